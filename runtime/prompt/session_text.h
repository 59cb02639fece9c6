#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lang/compile/entries.h"
#include "runtime/files/folder_sources.h"
#include "runtime/run/load.h"

namespace rob::runtime {

/// Where a word stands in a line, from `begin` on, whatever its capital letters; npos if it does
/// not.
std::size_t find_word(std::string_view line, std::string_view word, std::size_t begin = 0);
inline bool has_word(std::string_view line, std::string_view word) {
  return find_word(line, word) != std::string_view::npos;
}

/// The message about a block because its end has not been typed yet.
bool may_be_mended_below(const lang::Diagnostic& finding);

/// All that has been typed at a prompt, line by line from 1, for messages; and what of it counts
/// for the next entry, which is compiled for the robot of the prompt.
class SessionText {
 public:
  using Knowing = lang::Entries::Knowing;
  using As = lang::Entries::As;

  /// `points_file`: where TEACH keeps points; empty: nowhere.
  SessionText(motion::RobotModel robot, std::string points_file);

  /// Compiled after all that stays; nothing is kept of it before keep().
  LoadedProgram compile(std::string_view entry, Knowing knowing = Knowing::Needed,
                        As as = As::Statements) const;
  struct Reading {
    LoadedProgram compiled;
    As as = As::Statements;
  };
  /// The entry as it is meant: statements, or else an expression alone.
  Reading read(std::string_view entry) const;
  /// What is wrong with the last lines of a block that is open, from its `first` line on, counted
  /// from 0; written as rendered() does. Empty: nothing.
  std::string wrong_in_open(std::string_view block, std::uint32_t first) const;
  /// The entry has been taken, or refused: the next one begins on the line after it.
  void keep(std::string_view entry, const LoadedProgram& compiled);
  /// What was declared on these lines is forgotten: their entries have not been carried out.
  void forget(std::uint32_t first, std::uint32_t last) { entries_.forget(first, last); }
  /// A line that declares nothing: a command that is carried out as an entry.
  void pass_line(std::string_view line);
  /// This name means nothing any more. False if a routine uses it: then it stays.
  bool forget_name(const std::string& name) { return entries_.forget(name); }
  /// From now on points are kept there.
  void use_points(std::string file) { points_file_ = std::move(file); }

  /// The line on which the next entry begins.
  std::uint32_t line() const { return entries_.line(); }
  /// As it was typed.
  std::string_view typed(std::uint32_t line) const;
  /// A finding about one of the lines, or about a file that the entry USEs.
  std::string rendered(const lang::Diagnostic& finding,
                       const std::vector<lang::SourceFile>& used = {}) const;

  /// The declaration of this name by entries.
  std::optional<lang::DeclaredName> find(std::string_view name) const {
    return entries_.find(name);
  }
  std::vector<lang::DeclaredName> names() const { return entries_.names(); }
  /// The names that may stand after ALLOW.
  std::vector<std::string> bodies() const;
  /// Those that occur in a text.
  std::vector<lang::DeclaredName> named_in(std::string_view text) const {
    return entries_.named_in(text);
  }

 private:
  void add_typed(std::string_view text);

  motion::RobotModel robot_;
  lang::RobotSignature signature_;
  std::string points_file_;
  FolderSources sources_;
  lang::Entries entries_;
  std::string typed_;
  std::vector<std::size_t> begins_;  ///< of the lines in `typed_`
};

}  // namespace rob::runtime
