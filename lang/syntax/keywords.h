#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

/// The reserved words of the language. All are reserved, those of later versions too, so that a
/// program that is valid today stays valid.
namespace rob::lang {

enum class Keyword : std::uint8_t {
#define ROB_KEYWORD(enumerator, spelling, role) enumerator,
#include "lang/syntax/keywords.def"
#undef ROB_KEYWORD
};

/// Where a reserved word may stand.
enum class KeywordRole : std::uint8_t {
  Value,      ///< operators and literals: the only ones that may go on a line inside brackets
  Statement,  ///< begins a statement
  Closer,     ///< ends a block, or begins its next branch
  Part        ///< stands inside a statement
};

/// Case-insensitive.
std::optional<Keyword> find_keyword(std::string_view word);

std::string_view spelling(Keyword keyword);
KeywordRole role(Keyword keyword);

/// DIN, DOUT, AIN or AOUT, in any case: not reserved, but with an index always a channel.
bool is_channel_word(std::string_view word);

/// Words that can begin a line, closers included, for suggestions.
std::span<const std::string_view> statement_words();

}  // namespace rob::lang
