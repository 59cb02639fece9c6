#include "lang/syntax/used_files.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "lang/syntax/declarations.h"
#include "lang/syntax/outline.h"
#include "lang/syntax/parser.h"
#include "lang/syntax/robot_name.h"
#include "lang/syntax/source_context.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/source_text.h"

namespace rob::lang {
namespace {

/// Goes from a text to those that it USEs, before it is parsed itself.
class UseReader {
 public:
  UseReader(const Sources* sources, const RobotSignature& robot, Diagnostics& diagnostics,
            std::vector<SourceFile>& used, std::shared_ptr<TypeTable> types)
      : sources_(sources),
        robot_(robot),
        diagnostics_(diagnostics),
        used_(used),
        types_(std::move(types)) {
    used_.reserve(kMostUsedFiles);  // tokens point into the texts: they must stay where they are
  }

  Program read(std::string_view source, TextParts parts, std::uint32_t printed_from) {
    bytes_ = source.size();
    printed_from_ = printed_from;
    read(source, 0, parts);
    return linked();
  }

 private:
  struct File {
    Outline outline;
    Program program;
    bool open = true;  ///< what it USEs is being read
  };

  void read(std::string_view text, std::uint32_t number, TextParts parts = {}) {
    File& file = files_.emplace_back();
    if (check_source(text, diagnostics_, number, parts)) {
      file.outline = outline_of(text, number, parts);
      file.program = parse(text, diagnostics_,
                           {.file = number,
                            .parts = parts,
                            .outline = &file.outline,
                            .imports = imports_of(file.outline, number),
                            .nodes = nodes_,
                            .names = names_,
                            .array_lengths = array_lengths_.size(),
                            .printed_from = number == 0 ? printed_from_ : 0,
                            .types = types_});
      nodes_ = file.program.nodes;
      names_ = file.program.names;
      whole_ = whole_ && file.program.whole;
      std::ranges::move(file.program.array_lengths, std::back_inserter(array_lengths_));
    }
    file.open = false;
    if (number > 0) check_used(text, file);
  }

  std::vector<Import> imports_of(const Outline& outline, std::uint32_t by) {
    std::vector<Import> imports;
    for (const Outline::UsedName& use : outline.uses) {
      const auto earlier = std::ranges::find_if(
          imports, [&](const Import& import) { return same_word(import.name, use.name); });
      if (earlier != imports.end()) {
        diagnostics_.warning(
            code::kUsedTwice, use.place,
            fmt::format("{} is USEd in line {} already", shortened(use.name), earlier->line));
      } else if (const std::uint32_t number = import(use, by); number > 0) {
        File& file = files_[number];
        imports.push_back({use.name, use.place.line, number, &file.program});
      }
    }
    return imports;
  }

  /// The number of the file; 0 if it cannot be had.
  std::uint32_t import(const Outline::UsedName& use, std::uint32_t by) {
    if (sources_ == nullptr) return refuse(use, {"there are no files to USE here", ""});
    auto found = sources_->find(use.name, file(by).name);
    if (auto* const none = std::get_if<NoSource>(&found)) return refuse(use, std::move(*none));
    SourceFile& source = std::get<SourceFile>(found);
    for (std::uint32_t number = 0; number <= used_.size(); ++number) {
      if (file(number).identity != source.identity) continue;
      return files_[number].open ? refuse_circle(use, number) : number;
    }
    bytes_ += source.text.size();
    if (used_.size() == kMostUsedFiles || bytes_ > kMaxSourceBytes) return refuse_size(use);
    diagnostics_.name_file(source.name);
    used_.push_back(std::move(source));
    const auto number = static_cast<std::uint32_t>(used_.size());
    read(used_.back().text, number);
    return number;
  }

  const SourceFile& file(std::uint32_t number) const {
    return number == 0 ? sources_->program() : used_[number - 1];
  }

  std::uint32_t refuse(const Outline::UsedName& use, NoSource why,
                       std::string_view code = code::kUseNotFound) {
    diagnostics_.error(code, use.place, std::move(why.message), std::move(why.help));
    whole_ = false;
    return 0;
  }

  std::uint32_t refuse_circle(const Outline::UsedName& use, std::uint32_t back_to) {
    std::string chain = file(back_to).name;
    for (std::uint32_t number = back_to + 1; number < files_.size(); ++number) {
      if (files_[number].open) chain += fmt::format(" → {}", file(number).name);
    }
    return refuse(use,
                  {fmt::format("USE goes round in a circle: {} → {}", chain, file(back_to).name),
                   "what both need belongs in a third file"},
                  code::kUseCircle);
  }

  std::uint32_t refuse_size(const Outline::UsedName& use) {
    return refuse(use,
                  {fmt::format("too much is USEd: at most {} files, and {} MiB of text in all",
                               kMostUsedFiles, kMaxSourceBytes >> 20U),
                   ""},
                  code::kTooMuchUsed);
  }

  /// A USEd file holds declarations and routines; its TESTs are its own.
  void check_used(std::string_view text, const File& file) {
    const Program& program = file.program;
    const auto first = std::ranges::find_if_not(program.statements, is_declaration);
    if (first != program.statements.end()) {
      diagnostics_.error(code::kNotInUsedFile, first->place,
                         "a USEd file has declarations and routines only",
                         "put it into a PROC, or into the program that USEs this file");
    }
    const auto defaults = std::ranges::find_if(program.statements, [](const Statement& one) {
      return std::holds_alternative<Defaults>(one.node);
    });
    if (defaults != program.statements.end()) {
      diagnostics_.error(code::kNotInUsedFile, defaults->place,
                         "a USEd file has no DEFAULT: how the robot moves is up to the program",
                         "move it into the program, or write WITH … DO around the motions here");
    }
    if (program.header.law) {
      diagnostics_.error(code::kNotInUsedFile, program.header.law->place,
                         "a USEd file has no LAW: how the robot moves is up to the program",
                         "move it into the program");
    }
    const auto robot = program.header.robot ? declared_robot(text) : std::nullopt;
    if (!robot || robot->name == robot_.name) return;
    Place place = robot->place;
    place.file = program.end.file;
    diagnostics_.error(code::kUsedForOtherRobot, place,
                       fmt::format("this file is for {}, and the program runs on {}",
                                   shortened(robot->name), robot_.name),
                       "without ROBOT a file is for any robot");
  }

  /// The program with all that its files hold.
  Program linked() {
    Program whole = std::move(files_.front().program);
    files_.pop_front();
    whole.whole = whole_;
    whole.array_lengths = std::move(array_lengths_);
    whole.used_units.push_back(whole.header.units);
    for (File& file : files_) {
      Program& part = file.program;
      for (Routine& routine : part.routines) {
        if (routine.test) continue;
        routine.index = whole.routines.size();
        whole.routines.push_back(std::move(routine));
      }
      part.routines.clear();
      std::ranges::move(part.frame_uses, std::back_inserter(whole.frame_uses));
      whole.taught.merge(part.taught);
      whole.surroundings = whole.surroundings || part.surroundings;
      whole.used_units.push_back(part.header.units);
      whole.used.push_back(std::move(part));
    }
    return whole;
  }

  const Sources* sources_;
  const RobotSignature& robot_;
  Diagnostics& diagnostics_;
  std::vector<SourceFile>& used_;
  std::deque<File> files_;  ///< the program's own first
  std::size_t bytes_ = 0;
  std::uint32_t printed_from_ = 0;
  std::size_t nodes_ = 0;
  std::size_t names_ = 0;
  std::vector<Program::ArrayLength> array_lengths_;
  std::shared_ptr<TypeTable> types_;
  bool whole_ = true;
};

}  // namespace

Program read_program(std::string_view source, const Sources* sources, const RobotSignature& robot,
                     Diagnostics& diagnostics, std::vector<SourceFile>& used, TextParts parts,
                     std::shared_ptr<TypeTable> types, std::uint32_t printed_from) {
  return UseReader(sources, robot, diagnostics, used, std::move(types))
      .read(source, parts, printed_from);
}

}  // namespace rob::lang
