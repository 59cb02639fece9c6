#pragma once

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

/// A motion whose written coordinates are known before the program runs, so that it can be
/// checked against the robot while nothing moves yet. `command` holds the constant components only.
struct ConstantTarget {
  Place place;
  MoveCommand command;
};

/// Where a program asks for something that not every robot can do.
struct FeatureUse {
  Place place;
  MotionFeature feature = MotionFeature::Accel;
};

/// What compiling one source text yields.
struct Compilation {
  Diagnostics diagnostics;
  std::optional<Chunk> chunk;  ///< empty if the program has errors
  std::vector<ConstantTarget> constant_targets;
  std::vector<FeatureUse> features;
  std::vector<MissingPoint> missing_points;  ///< each has had a warning
  std::vector<SourceFile> used;              ///< the files that it USEs, by Place::file from 1
};

/// Lexer, parser, checker and compiler in a row; finds all errors of the text. Never throws for
/// what a text may contain. `points`: what the program's POINTs are worth. `sources`: where the
/// files are that it USEs; null: there are none.
Compilation compile(std::string_view source, const RobotSignature& robot,
                    const PointTable& points = {}, const Sources* sources = nullptr);

}  // namespace rob::lang
