#include "tests/support/rounded_polyline.h"

#include <doctest/doctest.h>

#include <cmath>

using rob::test::rounded_polyline;
using rob::test::time_optimal;
using rob::test::ToppLimits;
using rob::test::ToppNode;

namespace {

const ToppLimits kAxes{{1000, 1000, 1000}, {1000, 1000, 1000}, 300};

}  // namespace

TEST_CASE("a right angle rounded by 0.1 mm begins 0.2·√2 mm before it") {
  const auto nodes = rounded_polyline({{0, 0, 0}, {100, 0, 0}, {100, 100, 0}}, 0.1);
  REQUIRE(nodes.size() == 6);
  const double l = 0.4 / std::sqrt(2.0);
  CHECK(nodes[2].q[0] == doctest::Approx(100 - l));
  CHECK(nodes[3].q[1] == doctest::Approx(l));
  CHECK(nodes[3].sigma - nodes[2].sigma == doctest::Approx(2 * l));
  CHECK(nodes[2].ddq[1] == doctest::Approx(1 / (2 * l)));
}

TEST_CASE("short legs are shared half and half") {
  const auto nodes = rounded_polyline({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}}, 5);
  CHECK(nodes[2].q[0] == doctest::Approx(0.5));
  CHECK(nodes[3].q[1] == doctest::Approx(0.5));
  CHECK(nodes.back().q[0] == doctest::Approx(2));
}

TEST_CASE("the triangle's best known times come out") {
  const std::vector<Eigen::Vector3d> triangle = {{0, 0, 0}, {100, 0, 0}, {50, 86, 0}, {0, 0, 0}};
  ToppLimits axes = kAxes;
  CHECK(time_optimal(rounded_polyline(triangle, 0.1), axes, 20'000).time ==
        doctest::Approx(1.808).epsilon(0.003));
  CHECK(time_optimal(rounded_polyline(triangle, 1), axes, 20'000).time ==
        doctest::Approx(1.782).epsilon(0.003));
  axes.rate = 100;
  CHECK(time_optimal(rounded_polyline(triangle, 0.1), axes, 20'000).time ==
        doctest::Approx(3.252).epsilon(0.003));
}
