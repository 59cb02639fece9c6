#pragma once

#include "lang/check/checked_program.h"
#include "lang/machine/point_table.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Settles names, types, dimensions and constants of the whole program, and reports all that is
/// wrong with them. Where there were errors the result must not be compiled. `known`: of an entry
/// of the prompt, what it can name beside its own.
CheckedProgram check(Program program, const RobotSignature& robot, const PointTable& points,
                     const TargetJudge& judge, Diagnostics& diagnostics, KnownNames known = {});

}  // namespace rob::lang
