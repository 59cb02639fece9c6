#include "motion/space/pose.h"

#include <doctest/doctest.h>

#include <numbers>
#include <random>

using namespace rob::motion;

namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

TEST_CASE("a turns about x, b about y, c about z") {
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  CHECK((orientation_from({kPi / 2, 0, 0}) * y).isApprox(z));
  CHECK((orientation_from({0, kPi / 2, 0}) * z).isApprox(x));
  CHECK((orientation_from({0, 0, kPi / 2}) * x).isApprox(y));
}

TEST_CASE("fixed angles turn about the fixed axes: a first, c last") {
  // z: a = 90° → −y, b leaves it, c = 90° → +x.
  const auto turn = orientation_from({kPi / 2, kPi / 2, kPi / 2});
  CHECK((turn * Eigen::Vector3d(0, 0, 1)).isApprox(Eigen::Vector3d(1, 0, 0)));
}

TEST_CASE("fixed angles of an orientation give the orientation back") {
  std::mt19937 random(3);
  std::uniform_real_distribution<> full(-kPi, kPi);
  std::uniform_real_distribution<> half(-1.57, 1.57);
  for (int i = 0; i < 1000; ++i) {
    const FixedAngles angles{full(random), half(random), full(random)};
    const FixedAngles found = fixed_angles(orientation_from(angles));
    CHECK(found.a == doctest::Approx(angles.a).epsilon(1e-9));
    CHECK(found.b == doctest::Approx(angles.b).epsilon(1e-9));
    CHECK(found.c == doctest::Approx(angles.c).epsilon(1e-9));
  }
}

TEST_CASE("half a turn about z is +180°, from either side") {
  CHECK(fixed_angles(orientation_from({0, 0, kPi})).c == doctest::Approx(kPi));
  CHECK(fixed_angles(orientation_from({0, 0, -kPi})).c == doctest::Approx(kPi));
}

TEST_CASE("at b = ±90° the whole turn is in c") {
  for (const double b : {kPi / 2, -kPi / 2}) {
    const Eigen::Quaterniond turn = orientation_from({0.3, b, 0.5});
    const FixedAngles found = fixed_angles(turn);
    CHECK(found.a == 0);
    CHECK(found.b == doctest::Approx(b));
    CHECK(found.c == doctest::Approx(b > 0 ? 0.5 - 0.3 : 0.5 + 0.3));
    CHECK(orientation_from(found).angularDistance(turn) < 1e-7);
  }
}
