#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/program/load.h"

namespace rob::runtime {

/// Where a word stands in a line, from `begin` on, whatever its capital letters; npos if it does
/// not.
std::size_t find_word(std::string_view line, std::string_view word, std::size_t begin = 0);
inline bool has_word(std::string_view line, std::string_view word) {
  return find_word(line, word) != std::string_view::npos;
}

/// All that has been typed at a prompt, as the text in front of the next entry: what declares
/// something or arms a WHEN stays, of all else its line is left blank. So each entry is compiled
/// with the names of those before, and every message tells the line in which it was typed, from 1.
class SessionText {
 public:
  /// `points_file`: where TEACH keeps points; empty: nowhere.
  SessionText(motion::RobotModel robot, std::string points_file)
      : robot_(std::move(robot)), points_file_(std::move(points_file)) {}

  /// Compiled behind all that stays; nothing is kept of it before keep().
  LoadedProgram compile(std::string_view entry) const;
  /// The entry has been taken, or refused: the next one begins on the line behind it.
  void keep(std::string_view entry, const LoadedProgram& compiled);
  /// What was declared on these lines is forgotten: their entries have not been carried out.
  void forget(std::uint32_t first, std::uint32_t last);

  /// A line that declares nothing: a command that is carried out as an entry.
  void pass_line() { lines_.emplace_back(); }
  /// What was declared on this line has the effect that it has had, and is not repeated.
  void blank(std::uint32_t line) { lines_.at(line - 1).clear(); }
  /// This name means nothing any more. False if something that stays uses it: then it stays, too.
  bool forget_name(const std::string& name);
  /// From now on points are kept there.
  void use_points(std::string file) { points_file_ = std::move(file); }

  /// The line on which the next entry begins.
  std::uint32_t line() const { return static_cast<std::uint32_t>(lines_.size()) + 1; }
  /// The names that entries have declared.
  const std::vector<lang::DeclaredName>& names() const { return names_; }

 private:
  motion::RobotModel robot_;
  std::string points_file_;
  std::vector<std::string> lines_;
  std::vector<lang::DeclaredName> names_;
  int forgotten_ = 0;
};

}  // namespace rob::runtime
