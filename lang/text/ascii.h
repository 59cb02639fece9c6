#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "lang/text/utf8.h"

/// Letters and digits of the language, independent of the locale.
namespace rob::lang {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr bool begins_word(char c) { return is_letter(c) || c == '_'; }
constexpr bool in_word(char c) { return begins_word(c) || is_digit(c); }

constexpr char to_upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

inline std::string to_upper(std::string_view text) {
  std::string upper(text);
  std::ranges::transform(upper, upper.begin(), [](char c) { return to_upper(c); });
  return upper;
}

/// Keywords and names are the same whatever their capital letters.
inline bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return to_upper(x) == to_upper(y); });
}

/// A piece of a program for a message: at most 40 bytes of it, and whole characters.
inline std::string shortened(std::string_view text) {
  constexpr std::size_t kMost = 40;
  if (text.size() <= kMost) return std::string(text);
  std::size_t end = kMost;
  while (end > 0 && is_utf8_continuation(text[end])) --end;
  return std::string(text.substr(0, end)) + "\u2026";
}

}  // namespace rob::lang
