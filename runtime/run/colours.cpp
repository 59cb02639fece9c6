#include "runtime/run/colours.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace rob::runtime {

namespace {

struct Kind {
  std::string_view word;
  Colour colour;
};

constexpr std::array kKinds = {Kind{"error", Colour::Red}, Kind{"fault", Colour::Red},
                               Kind{"warning", Colour::Yellow}};

/// "error:", "error[E401]:" at the beginning of a text; 0: it is something else.
std::size_t length_of_kind(std::string_view text, std::string_view word) {
  if (!text.starts_with(word)) return 0;
  std::size_t end = word.size();
  if (end < text.size() && text[end] == '[') end = text.find(']', end) + 1;
  return end > 0 && end < text.size() && text[end] == ':' ? end + 1 : 0;
}

std::string coloured_line(std::string_view line) {
  for (std::size_t begin = 0; begin < line.size();) {
    const std::string_view rest = line.substr(begin);
    for (const Kind& kind : kKinds) {
      const std::size_t length = length_of_kind(rest, kind.word);
      if (length == 0) continue;
      return std::string(line.substr(0, begin)) + in_colour(rest.substr(0, length), kind.colour) +
             std::string(rest.substr(length));
    }
    const std::size_t next = line.find(": ", begin);
    if (next == std::string_view::npos) break;
    begin = next + 2;
  }
  return std::string(line);
}

}  // namespace

std::string in_colour(std::string_view text, Colour colour, std::string_view before,
                      std::string_view after) {
  constexpr std::array kCodes = {31, 32, 33};
  const int code = kCodes.at(static_cast<std::size_t>(colour));
  return fmt::format("{0}\033[{1}m{2}{3}{0}\033[0m{2}", before, code, after, text);
}

std::string coloured(std::string_view lines) {
  std::string text;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size() - 1) + 1;
    text += coloured_line(lines.substr(0, end));
    lines.remove_prefix(end);
  }
  return text;
}

}  // namespace rob::runtime
