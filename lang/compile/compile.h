#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/check/checked_program.h"
#include "lang/code/chunk.h"
#include "lang/compile/compiler.h"
#include "lang/machine/machine.h"
#include "lang/machine/point_table.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/used_files.h"
#include "lang/text/diagnostic.h"
#include "lang/text/text_parts.h"

namespace rob::lang {

/// The result of compiling one source text.
struct Compilation {
  Diagnostics diagnostics;
  std::optional<Chunk> chunk;      ///< empty if the program has errors
  std::optional<Header::Law> law;  ///< LAW of the program
  std::vector<FeatureUse> features;
  std::vector<MissingPoint> missing_points;  ///< each has had a warning
  std::vector<SourceFile> used;              ///< the files that it USEs, by Place::file from 1
  std::uint32_t begins = 0;  ///< asked for `from`: the line of the first statement; 0: none is left
  // For an entry of the prompt that has no errors:
  std::vector<KeptName> names;  ///< that it declares
  struct Shared {
    const KeptName* name;
    bool of_tasks;
  };
  std::vector<Shared> shared{};  ///< of those known before: shared with TASKs from here on
  /// Lines that later entries have to read again: of a routine, or a USE.
  struct Definition {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    bool use = false;
    std::vector<std::string> parameters{};  ///< of the routine
    std::string name{};                     ///< of the routine
    bool task = false;
  };
  std::vector<Definition> definitions;
  Room room;  ///< that is taken after it
  std::shared_ptr<const TypeTable> types;
};

/// Lexer, parser, checker and compiler in a row; finds all errors of the text. Never throws for
/// what a text may contain. `points`: what the program's POINTs are worth. A target that `judge`
/// refuses is an error of the program. `sources`: where the files are that it USEs; null: there
/// are none. `from`: the line at which a program begins; of what stands before at its top level
/// only the declarations are executed.
Compilation compile(std::string_view source, const RobotSignature& robot,
                    const PointTable& points = {}, const TargetJudge& judge = {},
                    const Sources* sources = nullptr, std::uint32_t from = 0);

/// An entry of the prompt, after the lines of earlier ones that it needs.
struct EntryText {
  std::string source;
  std::vector<TextPart> parts;
  std::uint32_t line = 1;  ///< on which the entry begins
  std::vector<const KeptName*> known;
  EntryRooms rooms;
  std::shared_ptr<TypeTable> types;  ///< with those that the entry can name
  bool printed = false;              ///< the entry is an expression; its value is printed
};

/// The same of an entry, to be executed by Vm::go_on_with().
Compilation compile(const EntryText& entry, const RobotSignature& robot, const PointTable& points,
                    const TargetJudge& judge, const Sources* sources);

}  // namespace rob::lang
