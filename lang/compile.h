#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "lang/chunk.h"
#include "lang/diagnostic.h"
#include "lang/machine.h"
#include "lang/missing_points.h"
#include "lang/point_table.h"
#include "lang/robot_signature.h"
#include "lang/used_files.h"

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

/// What compiling one source text yields.
struct Compilation {
  Diagnostics diagnostics;
  std::optional<Chunk> chunk;  ///< empty if the program has errors
  std::vector<FeatureUse> features;
  std::vector<MissingPoint> missing_points;  ///< each has had a warning
  std::vector<SourceFile> used;              ///< the files that it USEs, by Place::file from 1
};

/// Lexer, parser, checker and compiler in a row; finds all errors of the text. Never throws for
/// what a text may contain. `points`: what the program's POINTs are worth. A target that `judge`
/// refuses is an error of the program. `sources`: where the files are that it USEs; null: there
/// are none.
Compilation compile(std::string_view source, const RobotSignature& robot,
                    const PointTable& points = {}, const TargetJudge& judge = {},
                    const Sources* sources = nullptr);

}  // namespace rob::lang
