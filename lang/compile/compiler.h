#pragma once

#include <optional>

#include "lang/check/checker.h"
#include "lang/code/chunk.h"
#include "lang/machine/robot_signature.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Whether it gives a name at its level a meaning.
bool declares(const Statement& statement);

/// Turns a program that was checked without errors into code. Fails, with a message, only where a
/// limit of the code is exceeded.
std::optional<Chunk> generate(const CheckedProgram& checked, const RobotSignature& robot,
                              Diagnostics& diagnostics);

}  // namespace rob::lang
