#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "motion/path/follow.h"
#include "motion/path/tool_arc.h"
#include "motion/path/tool_line.h"
#include "motion/path/tool_spiral.h"
#include "motion/path/tool_spline.h"
#include "motion/path/way_cost.h"
#include "motion/space/rotation.h"
#include "tests/motion/generate/look_ahead_run.h"

using namespace rob::motion;
using Eigen::Vector3d;
using rob::test::LookAheadRun;

namespace {

constexpr const char* kChains[] = {"ur5e", "ur10e", "fr3", "lwa4p_urdf", "t3"};

/// A chain, led along ways of its flange.
struct ChainRun : LookAheadRun {
  explicit ChainRun(const char* name) : LookAheadRun(embedded_robot(name)) {}

  Pose beside(double x_mm, double y_mm, double z_mm, double turn = 0) {
    const Pose here = planner().tool_pose();
    return {here.position + Vector3d(x_mm, y_mm, z_mm) / 1000,
            rotation_by(Vector3d(0, 0, turn)) * here.orientation};
  }
  void along(const ToolPath& path, double zone) {
    MotionRequest how;
    how.zone = MotionRequest::Zone::Length;
    how.zone_value = zone;
    PlanOutcome outcome = planner().plan(how, path);
    REQUIRE(std::holds_alternative<PlannedSegment>(outcome));
    push(std::get<PlannedSegment>(outcome).segment);
  }
  void line(const Pose& to, double zone) {
    along(ToolLine::between(planner().tool_pose(), to).value(), zone);
  }
  Vector3d place(const GeneratorSample& sample) const {
    return robot().kinematics->forward(sample.reference.q).position;
  }
};

/// By differences of the positions alone, as shares of what the axes may.
struct Differences {
  double speed = 0;
  double acceleration = 0;
  double jerk = 0;
};

Differences differences(const ChainRun& run) {
  const double period = run.robot().reference_period;
  Differences most;
  const auto& samples = run.samples();
  for (std::size_t k = 3; k < samples.size(); ++k) {
    const auto q = [&](std::size_t back, int i) { return samples[k - back].reference.q[i]; };
    for (int i = 0; i < run.robot().axis_count(); ++i) {
      const Axis& axis = run.robot().axes[static_cast<std::size_t>(i)];
      const double first = q(0, i) - q(1, i);
      const double second = first - (q(1, i) - q(2, i));
      const double third = q(0, i) - 3 * q(1, i) + 3 * q(2, i) - q(3, i);
      most.speed = std::max(most.speed, std::abs(first) / period / axis.v_max);
      most.acceleration =
          std::max(most.acceleration, std::abs(second) / (period * period) / axis.a_max);
      most.jerk = std::max(most.jerk, std::abs(third) / std::pow(period, 3) / axis.j_max);
    }
  }
  return most;
}

}  // namespace

TEST_CASE("references of chains along lines, arcs and splines keep every axis within its limits") {
  for (const char* const name : kChains) {
    CAPTURE(name);
    ChainRun run(name);
    run.line(run.beside(30, 20, -20, 0.2), 0.002);
    run.line(run.beside(-20, 40, 10, -0.3), 0.002);
    const Pose from = run.planner().tool_pose();
    run.along(ToolArc::through(from, from.position + Vector3d(0.01, 0.01, 0), run.beside(20, 0, 0))
                  .value(),
              0.001);
    run.along(ToolSpline::through({run.planner().tool_pose(), run.beside(-15, 5, 5, 0.1),
                                   run.beside(-30, -10, 0, 0.2)})
                  .value(),
              0.001);
    run.stop();
    run.close();
    run.finish();
    REQUIRE_FALSE(run.all(MotionEvent::Kind::Finished).empty());
    const Differences most = differences(run);
    CHECK(most.speed <= 1 + 1e-6);
    CHECK(most.acceleration <= 1.03);
    CHECK(most.jerk <= 1.1);
    CHECK(most.speed > 0.01);
    const Pose end = run.planner().tool_pose();
    CHECK((run.place(run.samples().back()) - end.position).norm() < 1e-9);
  }
}

TEST_CASE("the flange of a chain stays within 1 um of its line and its spiral, turning evenly") {
  for (const char* const name : kChains) {
    CAPTURE(name);
    const RobotModel robot = embedded_robot(name);
    const Pose from = robot.kinematics->forward(robot.start);
    const Pose to{from.position + Vector3d(0.04, 0.05, -0.03),
                  rotation_by(Vector3d(0, 0, 0.4)) * from.orientation};
    const ToolLine line = ToolLine::between(from, to).value();
    const ToolSpiral spiral =
        ToolSpiral::inwards(from, Eigen::Quaterniond::Identity(), 0.004, 3).value();
    for (const ToolPath* path :
         {static_cast<const ToolPath*>(&line), static_cast<const ToolPath*>(&spiral)}) {
      const Followed followed = follow(robot, *path, {}, robot.start);
      REQUIRE_FALSE(followed.trouble.has_value());
      double off = 0;
      double turned = 0;
      for (int k = 0; k <= 500; ++k) {
        const double s = k / 500.0;
        const Pose is = robot.kinematics->forward(followed.axes.at(s).q);
        off = std::max(off, (is.position - path->at(s).position).norm());
        turned = std::max(turned, rotation_between(is.orientation, path->at(s).orientation).norm());
      }
      CHECK(off < 1e-6);
      CHECK(turned < 2e-5);
      // Nodes are within the steps in which the branch is proved.
      const auto& nodes = followed.axes.nodes();
      for (std::size_t i = 1; i < nodes.size(); ++i)
        CHECK((nodes[i].q - nodes[i - 1].q).cwiseAbs().maxCoeff() <= 0.05);
    }
  }
}

TEST_CASE("a line of a chain past a singular place is refused, and nothing of it is taken") {
  // UR5e: its flange's axis 5 place passes axis 1 nearer than the offset of its shoulder.
  const RobotModel robot = embedded_robot("ur5e");
  MotionPlanner planner(robot, robot.start);
  Pose to = planner.tool_pose();
  to.position = Vector3d(0.4, -to.position.y(), to.position.z());
  const PlanOutcome outcome = planner.plan({}, ToolLine::between(planner.tool_pose(), to).value());
  REQUIRE(std::holds_alternative<Refusal>(outcome));
  const Refusal& refusal = std::get<Refusal>(outcome);
  CHECK((refusal.kind == Refusal::Kind::PathSingular ||
         refusal.kind == Refusal::Kind::PathOutOfReach));
  CHECK(planner.last_number() == 0);
}

TEST_CASE("a line that leaves the reach of a chain is refused with the nearest pose") {
  const RobotModel robot = embedded_robot("ur5e");
  MotionPlanner planner(robot, robot.start);
  Pose to = planner.tool_pose();
  to.position.x() -= 0.8;
  const PlanOutcome outcome = planner.plan({}, ToolLine::between(planner.tool_pose(), to).value());
  REQUIRE(std::holds_alternative<Refusal>(outcome));
  const Refusal& refusal = std::get<Refusal>(outcome);
  CHECK(refusal.kind == Refusal::Kind::PathOutOfReach);
  REQUIRE(refusal.nearest.has_value());
  // Where the line ends being possible, the nearest pose is beside it.
  const double gone = refusal.at / refusal.way * 0.8;
  const Vector3d left = planner.tool_pose().position - Vector3d(gone, 0, 0);
  CHECK((refusal.nearest->position - left).norm() < 0.01);
}

TEST_CASE("seven axes come back to the pose that they left, no nearer to their limits") {
  const RobotModel robot = embedded_robot("fr3");
  MotionPlanner planner(robot, robot.start);
  Pose to = planner.tool_pose();
  to.position += Vector3d(0.05, 0.1, 0);
  const PlanOutcome there = planner.plan({}, ToolLine::between(planner.tool_pose(), to).value());
  REQUIRE(std::holds_alternative<PlannedSegment>(there));
  const Pose back = robot.kinematics->forward(robot.start);
  const PlanOutcome again = planner.plan({}, ToolLine::between(planner.tool_pose(), back).value());
  REQUIRE(std::holds_alternative<PlannedSegment>(again));
  CHECK((planner.tool_pose().position - back.position).norm() < 1e-9);
  CHECK(planner.tool_pose().orientation.angularDistance(back.orientation) < 1e-7);
  CHECK(limit_cost(robot, planner.commanded()) <= limit_cost(robot, robot.start) + 1e-9);
}
