#pragma once

#include "lang/code/chunk.h"
#include "lang/machine/machine.h"
#include "lang/values/setting.h"
#include "lang/vm/budget.h"
#include "lang/vm/stack.h"

/// Questions to the Machine about the world, about where axes bring the tool, and about what TASKs
/// share: the instruction of that name at `pc`. `n` are the registers of the frame, which the
/// answer goes to.
namespace rob::lang {

Reply read_signal(Machine& machine, int line, const Instruction* pc, Slot* n);
Reply read_group(Machine& machine, int line, const Instruction* pc, Slot* n);
Reply read_analog(Machine& machine, int line, const Instruction* pc, Slot* n);
/// Force and torque along the axes of the setting's frame.
Reply read_value(Machine& machine, int line, const Instruction* pc, Slot* n, const Setting& setting,
                 const Chunk& chunk);

Reply exists(Machine& machine, int line, const Instruction* pc, Slot* n, const std::string* t);
Reply forward(Machine& machine, int line, const Instruction* pc, Slot* n, const Chunk& chunk);
Reply at_joints(Machine& machine, int line, const Instruction* pc, Slot* n, const Chunk& chunk);
Reply inverse(Machine& machine, int line, const Instruction* pc, Slot* n, const Chunk& chunk);

/// Globals that TASKs use. Many of them cost the budget as any long block does.
Reply publish(Machine& machine, int line, const Instruction* pc, Stack& stack, Budget& budget);
Reply publish_list(Machine& machine, int line, const Instruction* pc, Stack& stack, Budget& budget);
Reply refresh(Machine& machine, int line, const Instruction* pc, Stack& stack, Budget& budget);

}  // namespace rob::lang
