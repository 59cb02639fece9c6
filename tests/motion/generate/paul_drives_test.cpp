#include <doctest/doctest.h>

#include <algorithm>

#include "motion/plan/torque_share.h"
#include "tests/motion/generate/arm_run.h"

using namespace rob::motion;
using namespace rob::test;

namespace {

/// The UMS-7 whose gears that carry no weight, of axes 1 and 6, bear so much less.
RobotModel weak_arm(double divisor) {
  RobotModel robot = embedded_robot("ums7");
  for (const std::size_t axis : {0U, 5U}) robot.mechanics->motors[axis].torque_max /= divisor;
  return robot;
}

JointVector beside_start(const RobotModel& robot, std::initializer_list<double> degrees) {
  JointVector q = robot.start;
  int axis = 0;
  for (const double value : degrees) q[axis++] += value * std::numbers::pi / 180;
  return q;
}

/// Two swings, there and back in a corner, and a halt.
struct Swung : GantryRun {
  Swung(const RobotModel& robot, Profile shape) : GantryRun(robot) {
    for (const auto& degrees : {std::initializer_list<double>{60, 20, -30, 40, 30, 90},
                                std::initializer_list<double>{-20, 30, 10, -60, -40, 0}}) {
      MotionRequest request = move_to(beside_start(robot, degrees));
      request.profile = shape;
      move(request);
    }
    close();
    finish();
  }
};

double most_asked(const GantryRun& run, const RobotModel& robot) {
  double most = 0;
  for (const GeneratorSample& sample : run.samples()) {
    const JointReference& r = sample.reference;
    most = std::max(most, torque_share(robot, r.q, r.qd, r.qdd).share);
  }
  return most;
}

double arrival(const GantryRun& run) { return run.events().back().time; }

}  // namespace

TEST_CASE("motions take as long as their gears need, in corners and profiles too") {
  const RobotModel strong = embedded_robot("ums7");
  const RobotModel weak = weak_arm(50);
  for (const Profile shape : {Profile::Unspecified, Profile::Cosine}) {
    const Swung fast(strong, shape);
    CHECK(most_asked(fast, weak) > 1.1);  // so the weak arm cannot do the same
    CHECK(most_asked(fast, strong) < TorqueShare::kMost);
    const Swung slow(weak, shape);
    CHECK(most_asked(slow, weak) < TorqueShare::kMost + 0.01);
    CHECK(most_asked(slow, weak) > TorqueShare::kMost - 0.2);
    CHECK(arrival(slow) > arrival(fast));
  }
}
