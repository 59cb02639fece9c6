#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rob::runtime {

/// The program in memory: lines, numbered from 1, as they were typed. Every edit can be undone.
class ProgramText {
 public:
  std::size_t size() const { return lines_.size(); }
  bool empty() const { return lines_.empty(); }
  const std::string& line(std::size_t number) const { return lines_.at(number - 1).text; }
  /// Each line with its end.
  std::string text() const;

  /// Line `number` becomes `text`.
  void replace(std::size_t number, std::string text);
  /// `text` becomes line `number`; at most one behind the last.
  void insert(std::size_t number, std::string text);
  void erase(std::size_t first, std::size_t last);
  /// All of it.
  void set(std::string_view text);

  /// What was typed at the prompt as the entry that begins in its line `entry`, at the end.
  void record(std::string_view text, std::uint32_t entry);
  /// The entries of these lines have failed: what was recorded of them goes.
  void take_back(std::uint32_t first, std::uint32_t last);

  /// False if there is nothing to undo, or to do again.
  bool undo();
  bool redo();

 private:
  struct Line {
    std::string text;
    std::uint32_t entry = 0;  ///< of the prompt, that it was recorded from; 0: none
  };
  using Lines = std::vector<Line>;

  void begin_edit();

  Lines lines_;
  std::vector<Lines> before_;  ///< the last edit's behind
  std::vector<Lines> undone_;
};

}  // namespace rob::runtime
