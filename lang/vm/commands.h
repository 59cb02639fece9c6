#pragma once

#include <span>
#include <string>

#include "lang/code/chunk.h"
#include "lang/code/watch.h"
#include "lang/machine/machine.h"
#include "lang/values/setting.h"
#include "lang/vm/errors.h"

/// Commands to the Machine, put together from registers. `n` points to the first register
/// of the instruction. An Objection: a value has turned out to be impossible.
namespace rob::lang {

/// `move` and `via`.
Objection build_move(const MoveForm& form, const Slot* n, MoveCommand& command);
/// `enter_defaults` and `set_defaults` of this line: nothing but clauses.
Objection build_defaults(const MoveForm& form, const Slot* n, int line, MoveCommand& clauses);
/// `move_to`: its components are words of the code.
MoveCommand plain_move(const MoveForm& form, const Instruction* components);
/// `on_the_way`, written at that place.
Objection build_path_place(bool before, const Slot* n, const Place& written, PathPlace& place);
/// UNTIL, WHEN and AT LIVE.
Watch watch_of(const Chunk& chunk, const WatchForm& form, const Slot* n, const Setting& setting);

/// WITH and IN; what is not named stays what it is around the block. `named`: opcodes.def.
Setting setting_of(unsigned named, const Slot* n, Setting around);
/// ALLOW: what holds around it, and these bodies may touch anything.
Setting allowing(const std::vector<std::string>& bodies, Setting around);
Objection build_press(int axis, const Slot* n, PressCommand& command);
/// Without COG the load is where the tip of the tool is.
Objection build_load(bool with_cog, const Slot* n, const Setting& setting, LoadCommand& load);
TaughtPoint taught_point(const Chunk& chunk, const Instruction* teach, const Slot* n,
                         const Slot* joints, const Setting& setting);
/// Copies what the machine has kept into the registers that it came from.
void take_kept(const TaughtPoint& point, const Chunk& chunk, Slot* pose, std::span<Slot> joints);

/// All other commands: they take everything from their registers, and the texts `t` of the frame.
/// Whether a group of `count` channels holds the value of write_group or simulate_group.
Objection check_group(Instruction command, std::uint32_t count, const Slot* n);
Reply set_group(Machine& machine, int line, Instruction command, int count, const Slot* n);
Objection check_command(Opcode opcode, const Slot* n);
Reply tell(Machine& machine, const Place& at, Instruction command, const Slot* n,
           const std::string* t);

}  // namespace rob::lang
