#pragma once

#include "lang/code/chunk.h"
#include "lang/vm/budget.h"
#include "lang/vm/errors.h"
#include "lang/vm/stack.h"

namespace rob::lang {

/// Executes the instruction at `pc`, a ROB_TEXT of opcodes.def: where the code goes on. With `why`
/// set it has failed.
const Instruction* step_text(const Instruction* pc, const Chunk& chunk, Stack& stack,
                             Objection& why);

/// Executes the instruction at `pc` if it is another one on texts, or on the memory of frames:
/// where the code goes on, `pc` itself if it is none of these. With `why` set it has failed.
///
/// Long blocks cost the budget an instruction for each kSlotsAnInstruction slots.
const Instruction* step_value(const Instruction* pc, const Chunk& chunk, Stack& stack,
                              Budget& budget, Objection& why);

}  // namespace rob::lang
