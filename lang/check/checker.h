#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "lang/check/kept_name.h"
#include "lang/check/missing_points.h"
#include "lang/check/symbols.h"
#include "lang/machine/machine.h"
#include "lang/machine/point_table.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Asked for every motion whose written coordinates are known before the program runs, while
/// nothing moves yet: why the robot cannot go there, or nothing. The command holds the constant
/// components only.
using TargetJudge = std::function<std::optional<Refusal>(const MoveCommand& command)>;

/// Where a program asks for something that not every robot can do.
struct FeatureUse {
  Place place;
  MotionFeature feature = MotionFeature::Accel;
};

/// A program whose names, types, dimensions and constants are settled.
struct CheckedProgram {
  Program program;
  std::deque<Symbol> symbols;  ///< all that Name::symbol and the like point to
  std::vector<FeatureUse> features;
  std::vector<MissingPoint> missing_points;
  /// What entries of the prompt have declared before.
  struct Known {
    const Symbol* symbol = nullptr;
    const KeptName* kept = nullptr;
  };
  std::vector<Known> known{};
};

/// Settles names, types, dimensions and constants of the whole program, and reports all that is
/// wrong with them. Where there were errors the result must not be compiled. `known`: of an entry
/// of the prompt, what it can name beside its own.
CheckedProgram check(Program program, const RobotSignature& robot, const PointTable& points,
                     const TargetJudge& judge, Diagnostics& diagnostics, KnownNames known = {});

}  // namespace rob::lang
