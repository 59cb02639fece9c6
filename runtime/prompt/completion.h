#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rob::runtime {

/// The names that there are at a prompt, beside the words of the language.
struct Vocabulary {
  std::vector<std::string> names;     ///< declared ones, and the robot's signals
  std::vector<std::string> points;    ///< those of `names` that are points
  std::vector<std::string> bodies{};  ///< bodies of the robot and obstacles, for ALLOW
  std::vector<std::string> robots;
  /// The contents of a folder ("": the current one, else with its '/'); folders end in '/'.
  std::function<std::vector<std::string>(const std::string& folder)> files;
};

/// The words that may stand for the last one before the cursor.
struct Completions {
  std::size_t begin = 0;           ///< of that word, in bytes
  std::vector<std::string> words;  ///< that go on with it, in any case; sorted, each once
  bool whole = false;              ///< a blank may follow
};

/// Knows what may stand where: statements, clauses after a motion's target, units after a
/// number, values elsewhere; commands after ':', and what they take; programs after USE.
/// `before`: of one line.
Completions complete(std::string_view before, const Vocabulary& known);

}  // namespace rob::runtime
