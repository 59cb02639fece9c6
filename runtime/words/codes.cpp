#include "runtime/words/codes.h"

#include <array>

namespace rob::runtime {

namespace {

constexpr auto kCodes = std::to_array<CodeText>({
#define ROB_CODE(number, name, title, explanation) {#number, title, explanation},
#include "runtime/words/codes.def"
#undef ROB_CODE
});

}  // namespace

std::span<const CodeText> all_codes() { return kCodes; }

}  // namespace rob::runtime
