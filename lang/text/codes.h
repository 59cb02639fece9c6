#pragma once

#include <span>
#include <string_view>

/// The codes of all messages. `code::kUnknownUnit` is "E111"; the table stands in codes.def.
///
/// To add one, append a line to its group in codes.def; nothing else is needed. The title says
/// in general what the message then says of one place, and is what `rob help E111` begins with.
namespace rob::lang {

namespace code {
#define ROB_CODE(number, name, title) inline constexpr std::string_view name = #number;
#include "lang/text/codes.def"
#undef ROB_CODE
}  // namespace code

struct CodeTitle {
  std::string_view code;
  std::string_view title;
};

/// All codes in the order of codes.def.
std::span<const CodeTitle> all_codes();

/// The title of a code ("E111"), or empty if there is no such code.
std::string_view title_of(std::string_view code);

}  // namespace rob::lang
