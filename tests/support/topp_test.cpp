#include "tests/support/topp.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

using rob::test::AxisValues;
using rob::test::parse_topp_path;
using rob::test::time_optimal;
using rob::test::ToppLimits;
using rob::test::ToppMotion;
using rob::test::ToppNode;

namespace {

constexpr double kAcceleration = 1000;

std::vector<ToppNode> line(const AxisValues& direction, double length) {
  const AxisValues none(direction.size(), 0.0);
  AxisValues end = direction;
  for (double& value : end) value *= length;
  return {{0, none, direction, none}, {length, end, direction, none}};
}

/// A turn of a circle about the origin, from (r, 0) on.
std::vector<ToppNode> circle(double r, int pieces) {
  std::vector<ToppNode> nodes;
  for (int k = 0; k <= pieces; ++k) {
    const double angle = 2 * std::numbers::pi * k / pieces, c = std::cos(angle),
                 s = std::sin(angle);
    nodes.push_back({r * angle, {r * c, r * s}, {-s, c}, {-c / r, -s / r}});
  }
  return nodes;
}

double greatest_rate(const ToppMotion& motion) {
  return *std::max_element(motion.rate.begin(), motion.rate.end());
}

}  // namespace

TEST_CASE("a line takes d/v + v/a, or 2·√(d/a) where v is not reached") {
  const ToppLimits limits{{100}, {kAcceleration}};
  CHECK(time_optimal(line({1}, 100), limits, 10'000).time == doctest::Approx(1.1).epsilon(1e-5));
  CHECK(time_optimal(line({1}, 4), limits, 10'000).time ==
        doctest::Approx(2 * std::sqrt(0.004)).epsilon(1e-5));
}

TEST_CASE("the axis that goes farthest bounds a slanted line, the rate bounds what is left") {
  // 0.8 of the way on axis 2: 125 mm/s and 1250 mm/s² along the line.
  const ToppLimits axes{{100, 100}, {kAcceleration, kAcceleration}};
  CHECK(time_optimal(line({0.6, 0.8}, 100), axes, 10'000).time ==
        doctest::Approx(100.0 / 125 + 125.0 / 1250).epsilon(1e-5));
  const ToppLimits paced{{100, 100}, {kAcceleration, kAcceleration}, 50};
  CHECK(time_optimal(line({0.6, 0.8}, 100), paced, 10'000).time ==
        doctest::Approx(100.0 / 50 + 50.0 / 1250).epsilon(1e-5));
}

TEST_CASE("a part of the path may ask for less speed than the rest") {
  // 100 mm with 200 mm/s, 100 mm with 100 mm/s: braked from 200 to 100 within 15 mm before them.
  auto nodes = line({1}, 200);
  nodes.insert(nodes.begin() + 1, {100, {100}, {1}, {0}, 100});
  nodes[0].rate = 200;
  const double first = 0.2 + (100 - 20 - 15) / 200.0 + 0.1;
  const double second = 95 / 100.0 + 0.1;
  CHECK(time_optimal(nodes, {{1e3}, {kAcceleration}}, 20'000).time ==
        doctest::Approx(first + second).epsilon(1e-4));
}

TEST_CASE("speeds of the axes alone: a circle takes ∫ max(|sin|, |cos|) r/v dθ = 4·√2·r/v") {
  constexpr double kRadius = 50, kV = 100;
  const ToppMotion motion = time_optimal(circle(kRadius, 360), {{kV, kV}, {1e9, 1e9}}, 20'000);
  CHECK(motion.time == doctest::Approx(4 * std::numbers::sqrt2 * kRadius / kV).epsilon(1e-3));
  CHECK(greatest_rate(motion) == doctest::Approx(kV * std::numbers::sqrt2).epsilon(1e-3));
}

TEST_CASE("a circle begins with its tangent's axis at full acceleration: y = a·t²/2") {
  constexpr double kRadius = 50, kF = 100;
  // y' = σ'·cos θ reaches its share of F where a·t = F·cos θ, with sin θ = a·t²/2r.
  double t = kF / kAcceleration;
  for (int k = 0; k < 50; ++k) {
    const double sine = kAcceleration * t * t / 2 / kRadius;
    t = kF * std::sqrt(1 - sine * sine) / kAcceleration;
  }
  const double theta = std::asin(kAcceleration * t * t / 2 / kRadius);
  const double even = (2 * std::numbers::pi - 2 * theta) * kRadius / kF;
  const ToppMotion motion =
      time_optimal(circle(kRadius, 360), {{1e3, 1e3}, {kAcceleration, kAcceleration}, kF}, 50'000);
  CHECK(motion.time == doctest::Approx(2 * t + even).epsilon(1e-5));
}

TEST_CASE("a parabola between two lines caps the speed: v² = 2·l·a") {
  // 100 mm along x, 100 mm along y; the corner takes 1 mm of each.
  constexpr double kLeg = 99, kL = 1;
  const std::vector<ToppNode> nodes = {
      {0, {0, 0}, {1, 0}, {0, 0}},
      {kLeg, {kLeg, 0}, {1, 0}, {0, 0}},
      {kLeg, {kLeg, 0}, {1, 0}, {-1 / (2 * kL), 1 / (2 * kL)}},
      {kLeg + 2 * kL, {kLeg + kL, kL}, {0, 1}, {-1 / (2 * kL), 1 / (2 * kL)}},
      {kLeg + 2 * kL, {kLeg + kL, kL}, {0, 1}, {0, 0}},
      {2 * kLeg + 2 * kL, {kLeg + kL, kLeg + kL}, {0, 1}, {0, 0}}};
  const double corner = std::sqrt(2 * kL * kAcceleration);
  const double peak = std::sqrt((2 * kAcceleration * kLeg + corner * corner) / 2);
  const double leg = (peak + (peak - corner)) / kAcceleration;
  const ToppMotion motion =
      time_optimal(nodes, {{1e4, 1e4}, {kAcceleration, kAcceleration}}, 50'000);
  CHECK(motion.time == doctest::Approx(2 * leg + 2 * kL / corner).epsilon(1e-5));
  CHECK(greatest_rate(motion) == doctest::Approx(peak).epsilon(1e-4));
}

TEST_CASE("a path file is read strictly") {
  const std::string header = "sigma,q1,q2,dq1,dq2,ddq1,ddq2\n";
  const auto nodes = parse_topp_path(header + "0,1,2,1,0,0,0\n0.5,1.5,2,1,0,0,-1e-3\n");
  REQUIRE(nodes.size() == 2);
  CHECK(nodes[1].sigma == 0.5);
  CHECK(nodes[1].q == AxisValues{1.5, 2});
  CHECK(nodes[1].dq == AxisValues{1, 0});
  CHECK(nodes[1].ddq == AxisValues{0, -1e-3});
  for (const char* rows :
       {"", "0,1,2,1,0,0,0\n", "0,1,2,1,0,0,0\n1,1,2,1,0,0\n", "1,1,2,1,0,0,0\n0,1,2,1,0,0,0\n",
        "0,1,2,1,0,0,x\n1,1,2,1,0,0,0\n", "0,1,2,1,0,0,0\n1,1,2,1,0,0,0"}) {
    CAPTURE(rows);
    CHECK_THROWS_AS(parse_topp_path(header + rows), std::runtime_error);
  }
  CHECK_THROWS_AS(parse_topp_path("s,q1,dq1,ddq1\n0,0,1,0\n1,1,1,0\n"), std::runtime_error);
}
