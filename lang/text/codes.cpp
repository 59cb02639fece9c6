#include "lang/text/codes.h"

#include <algorithm>
#include <array>

namespace rob::lang {

namespace {

constexpr auto kCodes = std::to_array<CodeTitle>({
#define ROB_CODE(number, name, title) {#number, title},
#include "lang/text/codes.def"
#undef ROB_CODE
});

}  // namespace

std::span<const CodeTitle> all_codes() { return kCodes; }

std::string_view title_of(std::string_view code) {
  const auto found = std::ranges::find(kCodes, code, &CodeTitle::code);
  return found == kCodes.end() ? std::string_view{} : found->title;
}

}  // namespace rob::lang
