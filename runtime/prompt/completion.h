#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace rob::runtime {

/// What there is to be named at a prompt, beside the words of the language.
struct Vocabulary {
  std::vector<std::string> names;   ///< declared ones, and the robot's signals
  std::vector<std::string> points;  ///< those of `names` that are points
  std::vector<std::string> robots;
  /// What lies in a folder ("": the present one, else with its '/'); folders end in '/'.
  std::function<std::vector<std::string>(const std::string& folder)> files;
};

/// What may stand for the last word before the cursor.
struct Completions {
  std::size_t begin = 0;           ///< of that word, in bytes
  std::vector<std::string> words;  ///< that go on with it, in any case; sorted, each once
  bool whole = false;              ///< a blank may follow
};

/// Knows what may stand where: statements, clauses behind a motion's target, units behind a
/// number, values elsewhere; commands behind ':', and what they take; programs behind USE.
/// `before`: of one line.
Completions complete(std::string_view before, const Vocabulary& known);

}  // namespace rob::runtime
