#include "lang/text/visible.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "lang/text/utf8.h"

namespace rob::lang {

namespace {

bool is_control(char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }

bool begins_line(char32_t c) {
  constexpr char32_t kNextLine = 0x85;
  constexpr char32_t kLineSeparator = 0x2028;
  constexpr char32_t kParagraphSeparator = 0x2029;
  return (c >= '\n' && c <= '\r') || c == kNextLine || c == kLineSeparator ||
         c == kParagraphSeparator;
}

/// Embeddings, overrides and isolates of the Unicode Bidirectional Algorithm (UAX #9).
bool turns_direction(char32_t c) {
  return (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
}

bool is_active(char32_t c) { return is_control(c) || begins_line(c) || turns_direction(c); }

std::string escaped(char32_t c) {
  if (c == '\n') return "\\n";
  if (c == '\t') return "\\t";
  return fmt::format("\\u{{{:X}}}", static_cast<unsigned>(c));
}

struct Sign {
  char32_t character;
  const char* ascii;
};

constexpr std::array kSigns = {
    Sign{U'\u2026', "..."}, Sign{U'\u2192', "->"},  Sign{U'\u2190', "<-"}, Sign{U'\u2191', "^"},
    Sign{U'\u2193', "v"},   Sign{U'\u00B0', "deg"}, Sign{U'\u00B7', "."},  Sign{U'\u2212', "-"},
    Sign{U'\u2013', "-"},   Sign{U'\u2014', "-"},   Sign{U'\u00D7', "x"},  Sign{U'\u00B1', "+-"},
    Sign{U'\u2264', "<="},  Sign{U'\u2265', ">="},  Sign{U'\u00B5', "u"},  Sign{U'\u00B2', "^2"},
    Sign{U'\u00B3', "^3"},  Sign{U'\u03C0', "pi"},  Sign{U'\u2018', "'"},  Sign{U'\u2019', "'"},
    Sign{U'\u201C', "\""},  Sign{U'\u201D', "\""}};

std::string ascii_of(char32_t c) {
  const auto sign = std::ranges::find(kSigns, c, &Sign::character);
  if (sign != kSigns.end()) return sign->ascii;
  if (c == U'\u2500') return "-";  // frames of tables
  if (c == U'\u2502') return "|";
  return c >= 0x2500 && c <= 0x257F ? "+" : escaped(c);
}

std::string escaped_for_json(char32_t c) {
  return fmt::format("\\u{:04x}", static_cast<unsigned>(c));
}

std::string escaped_byte(char byte) {
  return fmt::format("\\x{:02X}", static_cast<unsigned char>(byte));
}

/// Every character of which `is_replaced` holds as `escape` writes it.
template <typename IsReplaced, typename Escape>
std::string replaced(std::string_view text, IsReplaced is_replaced, Escape escape,
                     bool bytes_stay) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const CodePoint c = decode_utf8(text);
    const std::size_t length = c.length == 0 ? 1 : c.length;
    if (c.length == 0 && !bytes_stay) {
      shown += escaped_byte(text.front());
    } else if (c.length > 0 && is_replaced(c.value)) {
      shown += escape(c.value);
    } else {
      shown += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return shown;
}

}  // namespace

std::string visible(std::string_view text) { return replaced(text, is_active, escaped, false); }

std::string visible_lines(std::string_view text) {
  const auto replace = [](char32_t c) { return is_active(c) && c != '\n' && c != '\t'; };
  return replaced(text, replace, escaped, false);
}

std::string on_one_line(std::string_view text) {
  return replaced(text, begins_line, escaped, true);
}

std::string in_ascii(std::string_view text) {
  return replaced(
      text, [](char32_t c) { return c >= 0x80; }, ascii_of, true);
}

std::string visible_json(std::string_view document) {
  const auto replace = [](char32_t c) { return is_active(c) && c != '\n'; };
  return replaced(document, replace, escaped_for_json, true);
}

}  // namespace rob::lang
