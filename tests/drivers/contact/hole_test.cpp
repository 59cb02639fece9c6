#include "drivers/contact/hole.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/relative.h"

namespace rob::drivers {
namespace {

using Eigen::Vector3d;

constexpr double kStep = 0.25e-3;
constexpr double kClearance = 1e-3;
constexpr double kChamfer = 0.05e-3;
constexpr ContactLaw kSmooth{50e3, 0, 0};
constexpr Sinking kSinking{3e-3, 2000};

Hole hole() { return {Vector3d(0, 0, 0.06), 0.05, kClearance, kChamfer}; }

Carried at(double x, double z) { return {Vector3d(x, 0, z), Vector3d::Zero()}; }

Pressed carry(const Carried& carried, Foot& foot, int steps = 1) {
  Pressed pressed;
  for (int i = 0; i < steps; ++i)
    pressed = carry_into(hole(), carried, foot, kStep, kSmooth, kSinking);
  return pressed;
}

}  // namespace

TEST_CASE("a tube beside a hole presses on the face, over its mouth no longer") {
  Foot foot{Vector3d(1.06e-3, 0, 0.06)};
  CHECK(carry(at(1.06e-3, 0.0599), foot).force.z() == test::relative(5));
  CHECK(foot.tilted);
  // At 45° the chamfer lets it down as far as it is inside of its edge, at 1.05 mm. Carried at
  // 1.04 mm and 0.03 mm deep it is 0.02 mm too deep there: half of that each way.
  foot.place.x() = 1.04e-3;
  carry(at(1.04e-3, 0.05997), foot, 1000);
  CHECK(foot.place.x() == test::relative(1.03e-3));
  CHECK(foot.place.z() == test::relative(0.05998));
}

TEST_CASE("a tilted tube sinks with its own speed and the share of the force on it") {
  Foot foot{Vector3d(0, 0, 0.06), true};
  const Pressed first = carry(at(0, 0.0599), foot);
  // 3 mm/s + 5 N / 2000 N·s/m = 5.5 mm/s
  CHECK(0.06 - foot.place.z() == test::relative(5.5e-3 * kStep));
  CHECK(first.force.z() == test::relative(50e3 * (0.1e-3 - 5.5e-3 * kStep), 1e-6));
  CHECK(first.touching);
  // The force falls by k/d·dt a second towards that of its own speed: F(t) = (5 + 6)·e^(−25·t) − 6
  carry(at(0, 0.0599), foot, 39);
  const double time = 40 * kStep;
  const double force = 50e3 * (foot.place.z() - 0.0599);
  CHECK(force == doctest::Approx(11 * std::exp(-25 * time) - 6).epsilon(0.02));
}

TEST_CASE("a tube that comes from above goes straight in") {
  Foot foot{Vector3d(0, 0, 0.07)};
  CHECK_FALSE(carry(at(0, 0.065), foot).touching);
  CHECK_FALSE(carry(at(0, 0.04), foot).touching);
  CHECK(foot.place.z() == 0.04);
}

TEST_CASE("the wall holds a tube within the clearance, the bottom stops it") {
  Foot foot{Vector3d(0, 0, 0.03)};
  const Pressed led = carry(at(1.2e-3, 0.03), foot);
  CHECK(foot.place.x() == test::relative(kClearance));
  CHECK(led.force.x() == test::relative(-10));  // 0.2 mm · 50 N/mm
  CHECK(std::abs(led.force.z()) < 1e-9);
  const Pressed stopped = carry(at(1.2e-3, 0.0098), foot);
  CHECK(foot.place.z() == test::relative(0.01));
  CHECK(stopped.force.z() == test::relative(10));
  CHECK(stopped.force.x() == test::relative(-10));
}

TEST_CASE("what is shallow in a hole climbs out again over its edge, what is deep does not") {
  // 1 N down holds against 1 N to the side on a slope of 45°, 0.02 mm at 50 N/mm.
  Foot shallow{Vector3d(kClearance, 0, 0.06 - 0.02e-3)};
  carry(at(1.4e-3, 0.0599), shallow, 400);
  CHECK(shallow.place.z() == test::relative(0.06));
  CHECK(shallow.place.x() > kClearance + kChamfer);
  Foot deep{Vector3d(kClearance, 0, 0.06 - 0.06e-3)};
  carry(at(1.4e-3, 0.0599), deep, 400);
  CHECK(deep.place.x() < kClearance + 1e-9);
}

}  // namespace rob::drivers
