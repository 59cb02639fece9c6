#include "motion/ahead/extents.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "tests/support/random_text.h"

using namespace rob::motion;

namespace {

using Index = Extents::Index;

struct Written {
  double begin = 0;
  Index run = 0;
  Extent extent;
};

Extent random_extent(rob::test::Choice& choice) {
  Extent extent;
  const auto any = [&] { return choice.below(1000) / 8.0; };
  for (int i = 0; i < kMaxJoints; ++i) {
    extent.slopes[i] = any();
    extent.bends[i] = any();
    extent.swings[i] = any();
  }
  extent.asked = any();
  extent.fastest = any();
  extent.fastest_axis = choice.below(kMaxJoints);
  return extent;
}

Extent one_by_one(const std::vector<Written>& all, Index first, Index last) {
  Extent most;
  for (Index i = first; i <= last; ++i) {
    const Extent& its = all[i].extent;
    most.slopes = most.slopes.max(its.slopes);
    most.bends = most.bends.max(its.bends);
    most.swings = most.swings.max(its.swings);
    most.asked = std::max(most.asked, its.asked);
    most.fastest = std::min(most.fastest, its.fastest);
  }
  return most;
}

/// So many pieces in as many slots as given, of runs of ten or so.
void check_ring(std::size_t slots, Index pieces) {
  rob::test::Choice choice(slots);
  Extents extents(slots);
  std::vector<Written> all;
  double sigma = 0;
  for (Index i = 0; i < pieces; ++i) {
    const Index run = i == 0 || choice.percent(10) ? i : all.back().run;
    all.push_back({sigma, run, random_extent(choice)});
    extents.write(i, sigma, run, all.back().extent);
    sigma += 1 + choice.below(4);
    const Index oldest = i < slots ? 0 : i + 1 - slots;
    const Index first = oldest + static_cast<Index>(choice.below(static_cast<int>(i + 1 - oldest)));
    const Index last = first + static_cast<Index>(choice.below(static_cast<int>(i + 1 - first)));
    if (choice.percent(30)) {
      const double limit = choice.below(1000) / 8.0;
      extents.limit_asked(last, limit);
      all[last].extent.asked = std::min(all[last].extent.asked, limit);
    }
    CAPTURE(slots);
    CAPTURE(first);
    CAPTURE(last);
    const Extent expected = one_by_one(all, first, last);
    const Extent got = extents.greatest(first, last);
    CHECK((got.slopes == expected.slopes).all());
    CHECK((got.bends == expected.bends).all());
    CHECK((got.swings == expected.swings).all());
    CHECK(got.asked == expected.asked);
    CHECK(got.fastest == expected.fastest);
    CHECK(extents.greatest_asked(first, last) == expected.asked);

    const double place = choice.below(static_cast<int>(sigma) + 2) - 1;
    Index before = last;
    while (before > first && all[before].begin >= place) --before;
    CHECK(extents.last_before(place, first, last) == before);
    Index up_to = first;
    while (up_to < i && all[up_to + 1].run == all[first].run && all[up_to + 1].begin <= place)
      ++up_to;
    CHECK(extents.last_up_to(place, first, i + 1) == up_to);
  }
}

}  // namespace

TEST_CASE("the greatest of pieces in a ring are those found one by one") {
  for (const std::size_t slots : {1U, 2U, 7U, 64U, 100U}) check_ring(slots, 500);
}

TEST_CASE("of two pieces that are as fast the first one's axis stays") {
  Extent first;
  first.fastest = 2;
  first.fastest_axis = 1;
  Extent second = first;
  second.fastest_axis = 3;
  first.take(second);
  CHECK(first.fastest_axis == 1);
  second.fastest = 1;
  first.take(second);
  CHECK(first.fastest_axis == 3);
}
