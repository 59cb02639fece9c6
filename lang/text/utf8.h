#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// The little that Rob needs to know of UTF-8 (RFC 3629).
namespace rob::lang {

struct CodePoint {
  char32_t value = 0;
  std::size_t length = 0;  ///< bytes; 0: no valid UTF-8 begins here
};

/// The code point at the beginning of `text`, which is not empty. Overlong forms, surrogates and
/// what lies beyond U+10FFFF are not valid.
CodePoint decode_utf8(std::string_view text);

void append_utf8(std::string& text, char32_t code_point);

/// True for the second and later bytes of a character.
constexpr bool is_utf8_continuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Characters in valid UTF-8.
std::uint32_t count_code_points(std::string_view text);

/// A byte order mark at the beginning of a file is accepted and is no part of the text.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace rob::lang
