#include "runtime/run/kept_ends.h"

#include <doctest/doctest.h>

using rob::runtime::KeptEnds;

namespace {

constexpr std::int64_t kEach = KeptEnds<int>::kEach;

KeptEnds<std::int64_t> numbers(std::int64_t count) {
  KeptEnds<std::int64_t> kept;
  for (std::int64_t i = 0; i < count; ++i) kept.push_back(i);
  return kept;
}

}  // namespace

TEST_CASE("the first and the last 5,000 are kept, in their order, and all are counted") {
  CHECK(kEach == 5000);
  for (const std::int64_t count : {std::int64_t{0}, std::int64_t{1}, kEach, kEach + 1, 2 * kEach,
                                   2 * kEach + 1, 7 * kEach + 3}) {
    CAPTURE(count);
    KeptEnds<std::int64_t> kept = numbers(count);
    CHECK(kept.count() == count);
    const std::vector<std::int64_t> all = kept.take();
    const std::int64_t left_out = std::max<std::int64_t>(0, count - 2 * kEach);
    REQUIRE(static_cast<std::int64_t>(all.size()) == count - left_out);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto number = static_cast<std::int64_t>(i);
      CHECK(all[i] == (number < kEach ? number : number + left_out));
    }
  }
}

TEST_CASE("what is kept can be found by its number, and nothing else") {
  constexpr std::int64_t kCount = 2 * kEach + 10;
  KeptEnds<std::int64_t> kept = numbers(kCount);
  for (const std::int64_t there : {std::int64_t{0}, kEach - 1, kEach + 10, kCount - 1}) {
    REQUIRE(kept.find(there) != nullptr);
    CHECK(*kept.find(there) == there);
  }
  for (const std::int64_t gone : {kEach, kEach + 9, kCount, kCount + 5})
    CHECK(kept.find(gone) == nullptr);
}
