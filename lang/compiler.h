#pragma once

#include <optional>

#include "lang/checker.h"
#include "lang/chunk.h"
#include "lang/diagnostic.h"
#include "lang/robot_signature.h"

namespace rob::lang {

/// Turns a program that was checked without errors into code. Fails, with a message, only where a
/// limit of the code is exceeded.
std::optional<Chunk> generate(const CheckedProgram& checked, const RobotSignature& robot,
                              Diagnostics& diagnostics);

}  // namespace rob::lang
