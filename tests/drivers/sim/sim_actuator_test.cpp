#include "drivers/sim/sim_actuator.h"

#include <doctest/doctest.h>

#include "tests/support/relative.h"

namespace rob::drivers {
namespace {

// A lift on output 2 that takes half a second; inputs 0 (OFF end) and 5 (ON end).
SimActuator lift_at_off() {
  SimActuator lift({2, 0, 5, 0.5});
  lift.place_off();
  return lift;
}
constexpr std::uint64_t kOn = 1u << 2;
constexpr std::uint64_t kAtOff = 1u << 0;
constexpr std::uint64_t kAtOn = 1u << 5;

}  // namespace

TEST_CASE("an actuator stands at its OFF end until its output is set") {
  SimActuator lift = lift_at_off();
  lift.command(0, ~kOn);
  CHECK(lift.inputs(0) == kAtOff);
  CHECK(lift.inputs(100) == kAtOff);
}

TEST_CASE("an actuator leaves one end at once and reaches the other after its travel time") {
  SimActuator lift = lift_at_off();
  lift.command(1.0, kOn);
  CHECK(lift.inputs(1.0) == kAtOff);
  CHECK(lift.inputs(1.005) == 0);
  CHECK(lift.position(1.125) == test::relative(0.25));
  CHECK(lift.inputs(1.499) == 0);
  CHECK(lift.inputs(1.5) == kAtOn);
  CHECK(lift.inputs(9.0) == kAtOn);
}

TEST_CASE("an actuator that is turned round on the way takes as long back as it took there") {
  SimActuator lift = lift_at_off();
  lift.command(1.0, kOn);
  lift.command(1.2, 0);
  CHECK(lift.position(1.2) == test::relative(0.4));
  CHECK(lift.position(1.3) == test::relative(0.2));
  CHECK(lift.inputs(1.399) == 0);
  CHECK(lift.inputs(1.4) == kAtOff);
  lift.command(1.3, kOn);
  CHECK(lift.inputs(1.699) == 0);
  CHECK(lift.inputs(1.7) == kAtOn);
}

TEST_CASE("an output that is repeated every cycle does not start the travel anew") {
  SimActuator lift = lift_at_off();
  for (int k = 0; k <= 100; ++k) lift.command(k * 0.005, kOn);
  CHECK(lift.inputs(100 * 0.005) == kAtOn);
}

TEST_CASE("an actuator without travel time is at the other end at once") {
  SimActuator valve({2, 0, 5, 0});
  valve.place_off();
  CHECK(valve.inputs(0) == kAtOff);
  valve.command(3.0, kOn);
  CHECK(valve.inputs(3.0) == kAtOn);
}

}  // namespace rob::drivers
