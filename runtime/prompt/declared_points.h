#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>

namespace rob::runtime {

/// Which names the lines of a text that begin with POINT have, and how often: so nobody has to walk
/// through the text to find out whether it declares a point.
class DeclaredPoints {
 public:
  /// A line has come into the text, or has left it.
  void add(std::string_view line) { count(line, 1); }
  void remove(std::string_view line) { count(line, -1); }
  /// Whatever its capital letters.
  bool has(std::string_view name) const;

 private:
  void count(std::string_view line, int change);

  std::unordered_map<std::string, int> names_;  ///< in capitals
};

/// Whether a line of a text begins with POINT and has the name.
bool declares_point(std::string_view text, std::string_view name);

}  // namespace rob::runtime
