#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/prompt/declared_points.h"

namespace rob::runtime {

/// The program in memory: lines, numbered from 1, as they were typed. Every edit can be undone.
class ProgramText {
 public:
  /// A point that an edit has given another name.
  struct Renaming {
    std::string from;
    std::string to;
  };
  /// The result of an edit.
  struct Done {
    std::string what;  ///< "line 3 deleted: STOP"
    std::optional<Renaming> renaming{};
  };

  std::size_t size() const { return lines_.size(); }
  bool empty() const { return lines_.empty(); }
  const std::string& line(std::size_t number) const { return lines_.at(number - 1).text; }
  /// Each line with its end.
  std::string text() const;
  /// Whether a line of it begins with POINT and has the name.
  bool declares_point(std::string_view name) const { return points_.has(name); }
  /// Whether a word stands in it, outside of texts and comments.
  bool has_name(std::string_view name) const;

  // Each says what it did.
  /// Line `number` becomes `text`.
  std::string replace(std::size_t number, std::string text);
  /// `text` becomes line `number`; at most one after the last.
  std::string insert(std::size_t number, std::string text);
  std::string erase(std::size_t first, std::size_t last);
  /// All of it; `what` it is now, for people.
  void set(std::string_view text, std::string what);
  /// Wherever the name stands outside of texts and comments.
  void rename(const Renaming& renaming);

  /// What was typed at the prompt as the entry that begins in its line `entry`, at the end.
  void record(std::string_view text, std::uint32_t entry);
  /// The entries of these lines have failed: what was recorded of them goes.
  void take_back(std::uint32_t first, std::uint32_t last);

  /// What was undone, or done again; none if there is nothing.
  std::optional<Done> undo();
  std::optional<Done> redo();

 private:
  struct Line {
    std::string text;
    std::uint32_t entry = 0;  ///< of the prompt, that it was recorded from; 0: none
  };
  using Lines = std::vector<Line>;
  /// Puts lines in the place of others.
  struct Splice {
    std::size_t at = 0;
    std::size_t count = 0;  ///< of those that go
    Lines lines;            ///< that come
    Done done;
  };

  void edit(Splice splice);
  Splice apply(Splice splice);
  std::optional<Done> apply_last(std::vector<Splice>& from, std::vector<Splice>& to);

  Lines lines_;
  DeclaredPoints points_;       ///< in `lines_`
  std::vector<Splice> before_;  ///< each takes an edit back; the last edit's last
  std::vector<Splice> undone_;
};

}  // namespace rob::runtime
