#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace rob::runtime {

/// Takes the first line from what is left of a text, and returns it without its end.
inline std::string_view take_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

/// The lines of a text; one line's end at its end begins no further line.
inline std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) lines.emplace_back(take_line(text));
  return lines;
}

}  // namespace rob::runtime
