#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "lang/check/checker.h"
#include "lang/check/missing_points.h"
#include "lang/code/chunk.h"
#include "lang/machine/machine.h"
#include "lang/machine/point_table.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/used_files.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// What compiling one source text yields.
struct Compilation {
  Diagnostics diagnostics;
  std::optional<Chunk> chunk;      ///< empty if the program has errors
  std::optional<Header::Law> law;  ///< LAW of the program
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
