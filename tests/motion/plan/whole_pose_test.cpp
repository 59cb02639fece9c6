#include "motion/plan/whole_pose.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "motion/path/tool_line.h"
#include "motion/plan/motion_planner.h"
#include "motion/plan/reach.h"
#include "tests/motion/kinematics/five_axes.h"

using namespace rob::motion;
using Eigen::Vector3d;
using rob::test::five_axes;

namespace {

/// Lift, elbow and wrist add up to a quarter: the tool points straight down.
JointVector pointing_down() {
  JointVector q(5);
  q << 0.3, 0.2, 0.3, std::numbers::pi / 2 - 0.5, 0.7;
  return q;
}

/// The product of the published frames, one axis after the other: no code of the chain.
Pose five_forward(const RobotModel& robot, const JointVector& q) {
  const auto& chain = dynamic_cast<const ChainKinematics&>(*robot.kinematics).chain();
  Eigen::Isometry3d all = Eigen::Isometry3d::Identity();
  const auto place = [&](const Pose& pose) {
    all = all * Eigen::Translation3d(pose.position) * pose.orientation;
  };
  for (int i = 0; i < 5; ++i) {
    place(chain.joint(i).place);
    all = all * Eigen::AngleAxisd(q[i], Vector3d::UnitZ());
  }
  place(chain.flange());
  return {all.translation(), Eigen::Quaterniond(all.rotation())};
}

double off(const Pose& one, const Pose& other) {
  return (one.position - other.position).norm() +
         one.orientation.angularDistance(other.orientation);
}

Pose turned_about_z(const Pose& pose, double angle) {
  return {pose.position, Eigen::AngleAxisd(angle, Vector3d::UnitZ()) * pose.orientation};
}

const Refusal* refused(const PlanOutcome& outcome) { return std::get_if<Refusal>(&outcome); }

}  // namespace

TEST_CASE("straight down five axes reach a whole pose exactly, c included") {
  const RobotModel robot = five_axes();
  const JointVector q = pointing_down();
  const Pose down = five_forward(robot, q);
  REQUIRE((down.orientation * Vector3d::UnitZ()).z() < -1 + 1e-9);
  for (const double c : {-1.0, -0.2, 0.4, 0.9}) {
    const Pose asked = turned_about_z(down, c);
    const auto there = reach_whole(robot, asked, q);
    REQUIRE(there.has_value());
    CHECK(off(five_forward(robot, *there), asked) < 1e-7);
    // The last axis turns about as far; the others make good that the tip is 8 mm beside it.
    CHECK(std::abs(std::abs((*there)[4] - q[4]) - std::abs(c)) < 0.05);
  }
}

TEST_CASE("elsewhere five axes reach a whole pose only with the c that its place gives") {
  const RobotModel robot = five_axes();
  JointVector q(5);
  q << 0.3, 0.1, 0.2, 0.5, 0.4;
  const Pose made = five_forward(robot, q);
  const auto there = reach_whole(robot, made, robot.start);
  REQUIRE(there.has_value());
  CHECK(off(five_forward(robot, *there), made) < 1e-7);
  CHECK_FALSE(reach_whole(robot, turned_about_z(made, 0.02), robot.start).has_value());
  CHECK_FALSE(reach_whole(embedded_robot("ur5e"), made, JointVector::Zero(6)).has_value());
}

TEST_CASE("a line straight down turns c as it says, and leaves axis 5 where c is left out") {
  const RobotModel robot = five_axes();
  const JointVector q = pointing_down();
  const Pose down = five_forward(robot, q);
  Pose to = turned_about_z(down, 0.6);
  to.position += Vector3d(0.02, 0.03, 0.01);
  const auto line = ToolLine::between(down, to);
  REQUIRE(line.has_value());
  MotionRequest whole;
  whole.whole = true;
  for (const MotionRequest& request : {whole, MotionRequest{}}) {
    MotionPlanner planner(robot, q);
    const PlanOutcome outcome = planner.plan(request, *line);
    REQUIRE(refused(outcome) == nullptr);
    const auto& planned = std::get<PlannedSegment>(outcome);
    for (const double s : {0.25, 0.5, 1.0}) {
      const JointVector at = planned.segment.path->at(s).q;
      const Pose is = five_forward(robot, at);
      const Pose wanted = line->at(s);
      CHECK((is.position - wanted.position).norm() < 1e-6);
      CHECK((is.orientation * Vector3d::UnitZ()).z() < -1 + 1e-8);
      if (request.whole) CHECK(is.orientation.angularDistance(wanted.orientation) < 2e-5);
      if (!request.whole) CHECK(std::abs(at[4] - q[4]) < 1e-5);
    }
  }
}

TEST_CASE("a line that passes beside the vertical is refused as singular on five axes") {
  const RobotModel robot = five_axes();
  JointVector q = pointing_down();
  q[3] -= 0.3;  // leaning forwards in the arm's plane
  const Pose from = five_forward(robot, q);
  // Through a place 0.05 deg beside the vertical, across the arm's plane, to the other side.
  const Pose down = five_forward(robot, pointing_down());
  const Vector3d across = Eigen::AngleAxisd(q[0], Vector3d::UnitZ()) * Vector3d::UnitX();
  Pose to{from.position, from.orientation};
  const Eigen::Quaterniond half = down.orientation * from.orientation.conjugate();
  const Eigen::AngleAxisd beside(0.05 * rob::kDegree, across);
  to.orientation = beside * half * half * from.orientation;
  const auto line = ToolLine::between(from, to);
  REQUIRE(line.has_value());
  MotionPlanner planner(robot, q);
  const PlanOutcome outcome = planner.plan({}, *line);
  REQUIRE(refused(outcome) != nullptr);
  CHECK(refused(outcome)->kind == Refusal::Kind::PathSingular);
}

TEST_CASE("what five axes leave to the place turns about the tip of a tool") {
  const RobotModel robot = five_axes();
  const Pose pen{{0.04, 0.01, 0.03}, Eigen::Quaterniond::Identity()};
  JointVector q(5);
  q << 0.3, 0, 0.3, 0.5, 0.35;
  const auto tipped = tip_as_flange(robot, pen);
  REQUIRE(tipped.has_value());
  CHECK_FALSE(tip_as_flange(robot, {}).has_value());
  CHECK_FALSE(tip_as_flange(embedded_robot("ur5e"), pen).has_value());
  const Pose from = composed(five_forward(robot, q), pen);
  Pose to = from;
  to.position += Vector3d(0.01, 0.02, 0);
  const auto there = reach(*tipped, to, q);
  REQUIRE(there.has_value());
  const Pose is = composed(five_forward(robot, *there), pen);
  CHECK((is.position - to.position).norm() < 1e-8);
  // The same but for a turn about z.
  const Eigen::Quaterniond turn = is.orientation * to.orientation.conjugate();
  CHECK(std::hypot(turn.x(), turn.y()) < 1e-7);
  MotionPlanner planner(robot, q);
  planner.set_tool(pen);
  const auto line = ToolLine::between(from, to);
  REQUIRE(line.has_value());
  const PlanOutcome outcome = planner.plan({}, *line);
  REQUIRE(refused(outcome) == nullptr);
  const auto& planned = std::get<PlannedSegment>(outcome);
  for (const double s : {0.3, 0.6, 1.0}) {
    const Pose at = composed(five_forward(robot, planned.segment.path->at(s).q), pen);
    CHECK((at.position - line->at(s).position).norm() < 1e-6);
  }
}
