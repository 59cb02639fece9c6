#pragma once

#include <span>
#include <string_view>

/// The codes of what the planner, motion and foretelling find: for example `code::kBeyondLimit`,
/// E401. The table stands in codes.def; to add one, append a line to its group, and use its name.
namespace rob::runtime {

namespace code {
#define ROB_CODE(number, name, title, explanation) inline constexpr const char* name = #number;
#include "runtime/words/codes.def"
#undef ROB_CODE
}  // namespace code

struct CodeText {
  std::string_view code;
  std::string_view title;
  std::string_view explanation;
};

/// All codes in the order of codes.def.
std::span<const CodeText> all_codes();

}  // namespace rob::runtime
