#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>

namespace rob::runtime {

/// A line of `most`, counted from 1, as it was typed; none if it is no such number.
inline std::optional<std::size_t> line_number(const std::string& text, std::size_t most) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool valid = error == std::errc() && end == text.data() + text.size();
  return valid && number >= 1 && number <= most ? std::optional(number) : std::nullopt;
}

}  // namespace rob::runtime
