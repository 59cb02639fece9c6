#pragma once

#include "lang/code/chunk.h"
#include "lang/vm/budget.h"
#include "lang/vm/errors.h"
#include "lang/vm/stack.h"

namespace rob::lang {

/// Executes the instruction at `pc` if it is one on all elements of a row (opcodes.def): as
/// step_value() does. The budget pays for each element as for a slot of a long block.
const Instruction* step_row(const Instruction* pc, const Chunk& chunk, Stack& stack, Budget& budget,
                            Objection& why);

}  // namespace rob::lang
