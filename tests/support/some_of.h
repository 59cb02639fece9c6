#pragma once

#include <vector>

namespace rob::test {

/// What a test is repeated with. More of it brings other numbers rather than other code, so the
/// first is enough for a sanitizer, under which a test takes about ten times as long.
template <typename... Cases>
std::vector<const char*> some_of(const char* first, const Cases*... others) {
#ifdef ROB_SANITIZED
  return {first};
#else
  return {first, others...};
#endif
}

}  // namespace rob::test
