#include "drivers/contact/cap_thread.h"

#include <doctest/doctest.h>

#include <numbers>

#include "tests/drivers/contact/cell_bench.h"
#include "tests/support/relative.h"

namespace rob::drivers {
namespace {

constexpr double kTorsion = 100;
constexpr double kPi = std::numbers::pi;
constexpr double kSeat = 3.5 * kPi;

CapThread thread() { return {test::small_cell().cap, kTorsion}; }

void turn(CapThread& hand, double way, double& turned, int steps = 10000) {
  for (int i = 0; i < steps; ++i) hand.turn(way / steps, turned);
}

}  // namespace

TEST_CASE("the thread's friction rises over its last eighth of a turn") {
  CHECK(thread().friction(0) == test::relative(0.15));
  CHECK(thread().friction(kSeat - kPi / 4) == test::relative(0.15));
  CHECK(thread().friction(kSeat - kPi / 8) == test::relative(0.775));  // half-way to 1.4
  CHECK(thread().friction(kSeat) == test::relative(1.4));
}

TEST_CASE("a cap sinks by the pitch a turn") {
  CHECK(thread().sink(2 * kPi) == test::relative(3e-3));
  CHECK(thread().sink(kSeat) == test::relative(5.25e-3));
}

TEST_CASE("the hand twists before the cap follows, and is ahead by torque over torsion") {
  CapThread hand = thread();
  double turned = 0;
  hand.turn(0.001, turned);
  CHECK(turned == 0);
  CHECK(hand.torque() == test::relative(0.1));
  hand.turn(0.999, turned);
  CHECK(turned == test::relative(1 - 0.0015));
  CHECK(hand.torque() == test::relative(0.15));
}

TEST_CASE("near the seat the torque grows, at the seat the jaws slip and the cap stands") {
  CapThread hand = thread();
  double turned = kSeat - kPi / 4;
  // Where it is T, the hand has gone (T − 0.15)/1.25·45° of thread and T/100 rad of twist.
  turn(hand, (1.0 - 0.15) / 1.25 * kPi / 4 + 0.01, turned);
  CHECK(hand.torque() == test::relative(1.0, 1e-3));
  turn(hand, 1, turned);
  CHECK(hand.torque() == test::relative(1.4));
  CHECK(turned == test::relative(kSeat));
}

TEST_CASE("turning back loosens, down to where the cap is off the thread") {
  CapThread hand = thread();
  double turned = 1;
  turn(hand, -0.5, turned);
  CHECK(turned == test::relative(0.5015, 1e-6));
  CHECK(hand.torque() == test::relative(-0.15));
  turn(hand, -1, turned);
  CHECK(turned == 0);
  CHECK(hand.torque() == test::relative(-0.15));
}

}  // namespace rob::drivers
