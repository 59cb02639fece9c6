// TOOL4: a tip that touches one place, found from poses of the flange.
#include "lang/values/tool_fit.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace rob::lang;
using pose_math::operator+;
using pose_math::operator-;

namespace {

constexpr double kDeg = std::numbers::pi / 180;
const Vector3 kTip{30, -20, 120};
const Vector3 kPlace{200, 50, 10};

/// The flange that has the tip at the place, turned by fixed angles, deg.
PoseValue touching(double a, double b, double c) {
  const Quaternion turn = pose_math::from_fixed({a * kDeg, b * kDeg, c * kDeg});
  return {kPlace - pose_math::rotate(turn, kTip), turn};
}

std::vector<PoseValue> touches(double turn) {
  return {touching(180, 0, 0), touching(180 + turn, 0, 10), touching(180, turn, 20),
          touching(180 - turn, turn, -30), touching(180 + turn, -turn, 90)};
}

/// The sum of squares of the distances of the tip's places from their mean, over all pairs.
double spread(const std::vector<PoseValue>& flanges, const Vector3& tip) {
  double sum = 0;
  for (const PoseValue& one : flanges)
    for (const PoseValue& other : flanges) {
      const double apart =
          pose_math::length(pose_math::transform(one, tip) - pose_math::transform(other, tip));
      sum += apart * apart;
    }
  const auto count = static_cast<double>(flanges.size());
  return sum / (2 * count);
}

}  // namespace

TEST_CASE("TOOL4 finds a known tip from poses that touch one place") {
  for (const double turn : {15.0, 40.0, 90.0}) {
    CAPTURE(turn);
    const auto fit = fit_tool(touches(turn));
    REQUIRE(fit.has_value());
    CHECK(pose_math::length(fit->tip - kTip) < 1e-9);
    CHECK(fit->miss < 1e-10);
  }
}

TEST_CASE("with noise no other tip misses less, and the miss is the root mean square") {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.1);
  for (int run = 0; run < 20; ++run) {
    std::vector<PoseValue> flanges = touches(40);
    for (PoseValue& flange : flanges)
      flange.position = flange.position + Vector3{noise(random), noise(random), noise(random)};
    const auto fit = fit_tool(flanges);
    REQUIRE(fit.has_value());
    CHECK(pose_math::length(fit->tip - kTip) < 0.6);  // 0.1 over the sine of the turn, and a margin
    const double least = spread(flanges, fit->tip);
    CHECK(fit->miss == doctest::Approx(std::sqrt(least / 5)).epsilon(1e-9));
    for (const Vector3& off : {Vector3{0.01, 0, 0}, Vector3{0, 0.01, 0}, Vector3{0, 0, 0.01}}) {
      CHECK(spread(flanges, fit->tip + off) > least);
      CHECK(spread(flanges, fit->tip - off) > least);
    }
  }
}

TEST_CASE("TOOL4 refuses tools that are turned too little, or about one axis") {
  // A cross: those opposite are turned by twice as much from each other.
  const auto cross = [](double turn) {
    return fit_tool(std::vector<PoseValue>{touching(180 + turn, 0, 0), touching(180 - turn, 0, 0),
                                           touching(180, turn, 0), touching(180, -turn, 0)});
  };
  CHECK_FALSE(cross(4.9).has_value());
  CHECK(cross(5.1).has_value());
  // About one axis, however far; and by a hand that trembles by 2 deg about the others.
  std::vector<PoseValue> one_axis{touching(100, 0, 0), touching(140, 0, 0), touching(180, 0, 0),
                                  touching(220, 0, 0)};
  CHECK_FALSE(fit_tool(one_axis).has_value());
  one_axis[1] = touching(140, 2, 0);
  one_axis[2] = touching(180, 0, 2);
  CHECK_FALSE(fit_tool(one_axis).has_value());
  const std::vector<PoseValue> still(4, touching(180, 0, 0));
  CHECK_FALSE(fit_tool(still).has_value());
}
