#include "drivers/contact/plane_contact.h"

#include <doctest/doctest.h>

#include "tests/support/relative.h"

namespace rob::drivers {
namespace {

using Eigen::Vector3d;

constexpr ContactLaw kLaw{50e3, 1e-3, 0.2};
const Plane kTable{Vector3d(0, 0, 0.1), Vector3d::UnitZ()};

Carried held_at(double x, double z, double down = 0) {
  return {Vector3d(x, 0, z), Vector3d(0, 0, -down)};
}

}  // namespace

TEST_CASE("above a plane nothing acts, and the point is where it is carried") {
  const Pressed pressed = press(kTable, held_at(0.3, 0.1001), Vector3d(0.2, 0, 0.1), kLaw);
  CHECK_FALSE(pressed.touching);
  CHECK(pressed.place == Vector3d(0.3, 0, 0.1001));
  CHECK(pressed.force.isZero(0));
}

TEST_CASE("a plane pushes with stiffness times depth, and damping times the speed") {
  const Pressed still = press(kTable, held_at(0.3, 0.0998), Vector3d(0.3, 0, 0.1), kLaw);
  CHECK(still.force.z() == test::relative(10));  // 50 N/mm · 0.2 mm
  CHECK(still.place.z() == test::relative(0.1));
  const Pressed moving = press(kTable, held_at(0.3, 0.0998, 0.005), Vector3d(0.3, 0, 0.1), kLaw);
  CHECK(moving.force.z() == test::relative(10.25));  // 50 N·s/m · 5 mm/s more
  const Pressed leaving = press(kTable, held_at(0.3, 0.09999, -0.5), Vector3d(0.3, 0, 0.1), kLaw);
  CHECK(leaving.force.z() == 0);  // it does not pull
}

TEST_CASE("a pressed point sticks until its spring pulls with friction times the force across") {
  const Vector3d before(0.3, 0, 0.1);
  // 10 N down, so 2 N along: 0.04 mm of the spring.
  const Pressed stuck = press(kTable, held_at(0.30003, 0.0998), before, kLaw);
  CHECK(stuck.place.x() == test::relative(0.3));
  CHECK(stuck.force.x() == test::relative(-1.5));
  const Pressed slipped = press(kTable, held_at(0.301, 0.0998), before, kLaw);
  CHECK(slipped.force.x() == test::relative(-2));
  CHECK(slipped.place.x() == test::relative(0.30096));
}

TEST_CASE("on a slope without friction the force is across it") {
  const Plane slope{Vector3d::Zero(), Vector3d(-1, 0, 1).normalized()};
  const Pressed pressed = press(slope, held_at(0, -0.0001), Vector3d::Zero(), {50e3, 0, 0});
  // depth = 0.1 mm·cos 45°; both components 50e3·0.1e-3/2
  CHECK(pressed.force.x() == test::relative(-2.5));
  CHECK(pressed.force.z() == test::relative(2.5));
}

}  // namespace rob::drivers
