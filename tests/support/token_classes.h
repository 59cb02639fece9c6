#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace rob::test {

/// What the grammar writes in characters and the lexer cuts out as one token, and NL. A UNIT is one
/// where it is written; in a text it has several tokens.
inline bool is_token_class(std::string_view name) {
  constexpr std::array<std::string_view, 10> kClasses{
      "NL", "NAME", "NUMBER", "QUANTITY", "STRING", "UNIT", "LETTER", "DIGIT", "CHARACTER", "HEX"};
  return std::ranges::find(kClasses, name) != kClasses.end();
}

}  // namespace rob::test
