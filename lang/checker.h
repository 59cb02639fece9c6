#pragma once

#include <deque>
#include <vector>

#include "lang/ast.h"
#include "lang/compile.h"
#include "lang/diagnostic.h"
#include "lang/missing_points.h"
#include "lang/point_table.h"
#include "lang/robot_signature.h"
#include "lang/symbols.h"

namespace rob::lang {

/// A program whose names, types, dimensions and constants are settled.
struct CheckedProgram {
  Program program;
  std::deque<Symbol> symbols;  ///< all that Name::symbol and the like point to
  std::vector<FeatureUse> features;
  std::vector<MissingPoint> missing_points;
};

/// Settles names, types, dimensions and constants of the whole program, and reports all that is
/// wrong with them. Where there were errors the result must not be compiled.
CheckedProgram check(Program program, const RobotSignature& robot, const PointTable& points,
                     const TargetJudge& judge, Diagnostics& diagnostics);

}  // namespace rob::lang
