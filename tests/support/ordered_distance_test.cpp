#include "tests/support/ordered_distance.h"

#include <doctest/doctest.h>

#include <cmath>

namespace rob::test {
namespace {

using Eigen::Vector3d;
using Places = std::vector<Vector3d>;

/// So many places on each piece.
Places along(const Places& corners, int parts) {
  Places places{corners.front()};
  for (std::size_t i = 1; i < corners.size(); ++i)
    for (int k = 1; k <= parts; ++k)
      places.push_back(corners[i - 1] + (corners[i] - corners[i - 1]) * k / parts);
  return places;
}

const Places kCorner{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}};

}  // namespace

TEST_CASE("a path is at no distance from itself, and its parallel at theirs") {
  CHECK(ordered_distance(along(kCorner, 100), kCorner, 5) <= 1e-6);
  const Places beside{{0, 0, 0.3}, {10, 0, 0.3}, {10, 10, 0.3}};
  CHECK(ordered_distance(along(beside, 100), kCorner, 5) == doctest::Approx(0.3).epsilon(0.01));
}

TEST_CASE("a corner that is cut is missed by the height above the cut") {
  const Places cut{{0, 0, 0}, {8, 0, 0}, {10, 2, 0}, {10, 10, 0}};
  CHECK(ordered_distance(along(cut, 1000), kCorner, 5) ==
        doctest::Approx(std::sqrt(2.0)).epsilon(0.01));
}

TEST_CASE("the order counts: a path that comes back over itself has to be gone to its end") {
  const Places there_and_back{{0, 0, 0}, {10, 0, 0}, {4, 0, 0}, {10, 0, 0}};
  CHECK(ordered_distance(along(there_and_back, 100), there_and_back, 5) <= 1e-6);
  // Straight on one is 3 mm from the path at least once: at 7, while it goes from 10 to 4 and back.
  const Places straight{{0, 0, 0}, {10, 0, 0}};
  CHECK(ordered_distance(along(straight, 1000), there_and_back, 5) ==
        doctest::Approx(3).epsilon(0.01));
}

TEST_CASE("what does not begin or end where the path does is not on it") {
  CHECK(std::isinf(ordered_distance(along({{0, 0, 0}, {10, 0, 0}}, 100), kCorner, 5)));
  CHECK(std::isinf(ordered_distance(along({{10, 0, 0}, {10, 10, 0}}, 100), kCorner, 5)));
}

}  // namespace rob::test
