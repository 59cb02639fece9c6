#pragma once

#include <string>

#include "lang/code/chunk.h"

namespace rob::lang {

/// A chunk as a listing for people, a line for each instruction: its offset, the source line where
/// that changes, the instruction, its operands, and what they mean.
///
///        0     3  load_constant  r1 k0            // 40mm
///        1        move           r1 m0            // x, y, theta
///
/// r is a number register, s a text register, with the name of the variable that lives there;
/// constants are shown as the language writes them.
std::string disassemble(const Chunk& chunk);

}  // namespace rob::lang
