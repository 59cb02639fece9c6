#pragma once

#include <cstdint>
#include <optional>
#include <string>
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

/// A name that the text has declared at its top level.
struct DeclaredName {
  enum class Kind : std::uint8_t { Variable, Const, Point, Signal, Routine, Record };
  Kind kind = Kind::Variable;
  std::string name;
  std::string type;  ///< in words
  Place place;
};

/// What compiling one source text yields.
struct Compilation {
  Diagnostics diagnostics;
  std::optional<Chunk> chunk;      ///< empty if the program has errors
  std::optional<Header::Law> law;  ///< LAW of the program
  std::vector<FeatureUse> features;
  std::vector<MissingPoint> missing_points;  ///< each has had a warning
  std::vector<SourceFile> used;              ///< the files that it USEs, by Place::file from 1
  std::uint32_t begins = 0;  ///< asked for `from`: the line of the first statement; 0: none is left
  // Of an entry of the prompt:
  bool lasts = false;               ///< it declares a name or arms a WHEN
  std::vector<DeclaredName> names;  ///< that the next entry can use, those declared anew once
};

/// Lexer, parser, checker and compiler in a row; finds all errors of the text. Never throws for
/// what a text may contain. `points`: what the program's POINTs are worth. A target that `judge`
/// refuses is an error of the program. `sources`: where the files are that it USEs; null: there
/// are none. `entry`: the line from which the text is an entry of the prompt, to be executed by
/// Vm::go_on_with(); 0: it is a program. `from`: the line at which a program begins; of what stands
/// before at its top level only the declarations are executed.
Compilation compile(std::string_view source, const RobotSignature& robot,
                    const PointTable& points = {}, const TargetJudge& judge = {},
                    const Sources* sources = nullptr, std::uint32_t entry = 0,
                    std::uint32_t from = 0);

}  // namespace rob::lang
