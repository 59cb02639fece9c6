#pragma once

#include <string>

#include "lang/machine/robot_signature.h"
#include "tests/support/grammar.h"

namespace rob::test {

/// A program that compiles: declarations of every kind, and behind them sentences of the grammar,
/// each kept only if the program compiles with it. So it gets beyond the parser, where sentences
/// with names at random do not. `tries`: how many sentences are offered; `kept`: how many were
/// taken.
std::string compiling_program(const Grammar& grammar, Decisions& decisions,
                              const lang::RobotSignature& robot, int tries, int& kept);

}  // namespace rob::test
