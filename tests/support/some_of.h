#pragma once

#include <vector>

namespace rob::test {

// What a test is repeated with. More of it brings other numbers rather than other code, so a part
// is enough for a sanitizer, under which a test takes about ten times as long.

#ifdef ROB_SANITIZED
inline constexpr bool kAll = false;
#else
inline constexpr bool kAll = true;
#endif

/// All cases, or the first.
template <typename Case, typename... Cases>
std::vector<Case> some_of(Case first, Cases... others) {
  if (!kAll) return {first};
  return {first, others...};
}

/// Of rounds: each, or each eighth.
inline constexpr int kEach = kAll ? 1 : 8;

}  // namespace rob::test
