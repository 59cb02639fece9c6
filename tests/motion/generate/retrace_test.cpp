#include "motion/generate/retrace.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "motion/robots/robot_model.h"
#include "tests/support/no_allocation.h"

using rob::motion::JointVector;
using rob::motion::PathRecord;
using rob::motion::Retrace;

namespace {

constexpr double kRetracePeriod = 0.01;

/// A quarter of a circle of 40 mm about (0, 40 mm), from rest to rest in a second: the angle is
/// π/2·(t − sin 2πt/2π).
JointVector arc(double t) {
  constexpr double kPi = std::numbers::pi;
  const double angle = kPi / 2 * (t - std::sin(2 * kPi * t) / (2 * kPi));
  return JointVector{{0.04 * std::sin(angle), 0.04 * (1 - std::cos(angle)), 0}};
}

/// Two axes of 0.2 m/s, 1 m/s² and 20 m/s³, the third slower; the arc is within all of them.
rob::motion::RobotModel robot() {
  rob::motion::RobotModel robot;
  robot.reference_period = kRetracePeriod;
  for (const double share : {1.0, 1.0, 0.5}) {
    rob::motion::Axis axis;
    axis.v_max = 0.2 * share;
    axis.a_max = 1 * share;
    axis.j_max = 20 * share;
    robot.axes.push_back(axis);
  }
  return robot;
}

void drive_arc(Retrace& retrace) {
  retrace.add(arc(0));
  retrace.mark(1, false);
  for (int k = 1; k <= 100; ++k) {
    retrace.add(arc(k / 100.0));
    if (k == 50) retrace.mark(2, false);
  }
}

/// Drives to where it comes to rest; the farthest that it was from the circle, m.
double drive(Retrace& retrace) {
  double off = 0;
  while (retrace.moving()) {
    retrace.pass(kRetracePeriod);
    const JointVector q = retrace.reference(0).q;
    off = std::max(off, std::abs(std::hypot(q[0], q[1] - 0.04) - 0.04));
  }
  return off;
}

}  // namespace

TEST_CASE("the record is the way, and what lies between its places is on it") {
  PathRecord record(1000);
  for (int k = 0; k <= 100; ++k) record.add(arc(k / 100.0));
  record.add(arc(1));  // stands
  CHECK(record.last() == 100);
  for (double place = 2; place < 98; place += 0.37) {
    const auto at = record.at(place);
    CHECK((at.q - arc(place / 100)).norm() < 1e-7);
    const JointVector slope = (arc((place + 0.01) / 100) - arc((place - 0.01) / 100)) / 0.02;
    CHECK((at.qd - slope).norm() < 1e-6);
  }
}

TEST_CASE("a full record keeps the last places, and the marks on them") {
  PathRecord record(10);
  for (int k = 0; k < 25; ++k) {
    record.add(JointVector{{k * 1.0}});
    if (k % 5 == 0) record.mark(static_cast<rob::motion::Tag>(k + 1));
  }
  CHECK(record.first() == 15);
  CHECK(record.mark_before(24)->tag == 21);
  CHECK(record.mark_before(20)->place == 15);
  CHECK_FALSE(record.mark_before(15));
  record.cut(18.5);
  CHECK(record.last() == 19);
  CHECK(record.at(19).q[0] == doctest::Approx(18.5));
  CHECK(record.first() == 15);  // the places before are overwritten
  CHECK(record.mark_before(19)->tag == 16);
}

TEST_CASE("the way back goes from motion to motion, and forth again to where it began") {
  Retrace retrace(robot(), 1000);
  CHECK_FALSE(retrace.back(1));
  drive_arc(retrace);
  REQUIRE(retrace.back(1));
  CHECK(retrace.tag() == 2);
  CHECK(drive(retrace) < 1e-7);
  CHECK((retrace.reference(0).q - arc(0.5)).norm() < 1e-15);
  REQUIRE(retrace.back(1));
  CHECK(retrace.tag() == 1);
  drive(retrace);
  CHECK((retrace.reference(0).q - arc(0)).norm() < 1e-15);
  CHECK_FALSE(retrace.back(1));
  CHECK(retrace.away());
  retrace.forth(1);
  CHECK(drive(retrace) < 1e-7);
  CHECK_FALSE(retrace.away());
}

TEST_CASE("a hold for a motion counts as standing where that begins") {
  Retrace retrace(robot(), 1000);
  retrace.add(arc(0));
  retrace.mark(1, false);
  for (int k = 1; k <= 60; ++k) {
    retrace.add(arc(k / 100.0));
    if (k != 50) continue;
    retrace.mark(2, false);
    retrace.hold_at_mark();
  }
  REQUIRE(retrace.back(1));
  CHECK(retrace.tag() == 1);
}

TEST_CASE("speed, acceleration and jerk of every axis stay below their shares of the limits") {
  Retrace retrace(robot(), 1000);
  drive_arc(retrace);
  retrace.back(1);
  retrace.back(1);  // to the beginning
  std::vector<rob::motion::JointReference> way;
  for (double t = 0; retrace.moving(); t += 0.001) {
    retrace.pass(0.001);
    way.push_back(retrace.reference(t));
    if (way.size() == 500) retrace.halt();
    if (!retrace.moving() && retrace.away() && way.size() < 2000) retrace.forth(1);
  }
  REQUIRE(way.size() > 1000);
  for (std::size_t i = 1; i < way.size(); ++i) {
    const auto& [time, q, qd, qdd] = way[i];
    const JointVector moved = (q - way[i - 1].q) / 0.001;
    CHECK((moved - (qd + way[i - 1].qd) / 2).cwiseAbs().maxCoeff() < 1e-5);
    for (int axis : {0, 1}) {
      CHECK(std::abs(qd[axis]) <= 0.1);
      CHECK(std::abs(qdd[axis]) <= 0.75);
      CHECK(std::abs(qdd[axis] - way[i - 1].qdd[axis]) <= 0.75 * 20 * 0.001 * 1.02);
    }
  }
}

TEST_CASE("recording and going back take no memory") {
  Retrace retrace(robot(), 50);
  const rob::test::NoAllocation guard;
  drive_arc(retrace);
  retrace.back(1);
  drive(retrace);
  retrace.forth(1);
  drive(retrace);
  retrace.back(0.5);
  retrace.halt();
  drive(retrace);
  retrace.stay();
  CHECK(guard.count() == 0);
}

TEST_CASE("where it stays, the record ends, and goes on from there") {
  Retrace retrace(robot(), 1000);
  drive_arc(retrace);
  retrace.back(1);
  drive(retrace);
  retrace.stay();
  CHECK_FALSE(retrace.away());
  for (int k = 1; k <= 10; ++k) {
    retrace.add(arc(0.5) + JointVector{{k * k * 1e-5, 0, 0}});
    if (k == 1) retrace.mark(3, true);  // began between the two
  }
  REQUIRE(retrace.back(1));
  CHECK(retrace.tag() == 3);
  drive(retrace);
  CHECK((retrace.reference(0).q - arc(0.5)).norm() < 1e-15);
  REQUIRE(retrace.back(1));
  CHECK(retrace.tag() == 1);
}
