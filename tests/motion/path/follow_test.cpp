#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "motion/path/follow.h"
#include "motion/path/tool_arc.h"
#include "motion/path/tool_line.h"
#include "motion/path/tool_spiral.h"
#include "motion/path/tool_spline.h"
#include "motion/robots/robot_library.h"
#include "motion/space/rotation.h"
#include "tests/motion/kinematics/arms.h"

using namespace rob::motion;
using namespace rob::test;
using Eigen::Vector3d;

namespace {

Pose tip_at(const RobotModel& robot, const JointVector& q, const Pose& tip) {
  const Pose flange = robot.kinematics->forward(q);
  return {place_of(tip.position, flange), flange.orientation * tip.orientation};
}

struct Worst {
  double place = 0;
  double turn = 0;
};

/// Between nodes as well as on them.
Worst off_path(const RobotModel& robot, const ToolPath& path, const Pose& tip,
               const JointPath& axes) {
  Worst worst;
  axes.survey(13, [&](double s, const PathPoint& point) {
    const Pose is = tip_at(robot, point.q, tip);
    const Pose wanted = path.at(s);
    worst.place = std::max(worst.place, (is.position - wanted.position).norm());
    worst.turn = std::max(worst.turn, rotation_between(is.orientation, wanted.orientation).norm());
  });
  return worst;
}

double greatest_step(const JointPath& axes) {
  double most = 0;
  for (std::size_t i = 1; i < axes.nodes().size(); ++i)
    most = std::max(most, (axes.nodes()[i].q - axes.nodes()[i - 1].q).cwiseAbs().maxCoeff());
  return most;
}

const Pose kTip{Vector3d(0.02, -0.01, 0.1), rotation_by(Vector3d(0.3, 0.2, -0.1))};

}  // namespace

TEST_CASE("the tip of an arm stays within 0.001 mm and 1e-5 rad of a line and an arc") {
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    const RobotModel robot = embedded_robot(name);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(-1, 1);
    int followed = 0;
    for (int n = 0; n < 40; ++n) {
      JointVector q = robot.start;
      for (int i = 0; i < 6; ++i) q[i] += 0.3 * share(random);
      const Pose from = tip_at(robot, q, kTip);
      const Vector3d shift = 0.15 * Vector3d(share(random), share(random), share(random));
      const Vector3d turn = 0.5 * Vector3d(share(random), share(random), share(random));
      const Pose to{from.position + shift, rotation_by(turn) * from.orientation};
      const auto line = ToolLine::between(from, to);
      const auto arc = ToolArc::through(
          from, from.position + shift / 2 + 0.05 * Vector3d(share(random), 1, share(random)), to);
      REQUIRE((line && arc));
      for (const ToolPath* const path :
           {static_cast<const ToolPath*>(&*line), static_cast<const ToolPath*>(&*arc)}) {
        const Followed axes = follow(robot, *path, kTip, q);
        if (axes.trouble) continue;
        ++followed;
        const Worst worst = off_path(robot, *path, kTip, axes.axes);
        CHECK(worst.place < 1e-6);
        CHECK(worst.turn < 1e-5);
        CHECK(greatest_step(axes.axes) < 5.001 * kDegree);
        CHECK((axes.axes.at(0).q - q).norm() < 1e-14);
      }
    }
    CHECK(followed > 40);
  }
}

TEST_CASE("the rates along a followed line are those of the Jacobian") {
  const RobotModel robot = embedded_robot("irb120");
  const auto kinematics = arm("irb120");
  const Pose from = robot.kinematics->forward(robot.start);
  const Pose to{from.position + Vector3d(-0.05, 0.1, 0.05),
                rotation_by(Vector3d(0.2, 0.1, 0.3)) * from.orientation};
  const auto line = ToolLine::between(from, to);
  REQUIRE(line.has_value());
  const Followed axes = follow(robot, *line, {}, robot.start);
  REQUIRE_FALSE(axes.trouble.has_value());
  Eigen::Matrix<double, 6, 1> wanted;
  wanted << line->shift(), line->rotation();
  for (const JointPath::Node& node : axes.axes.nodes()) {
    const Eigen::Matrix<double, 6, 1> is = kinematics->jacobian(node.q) * node.qd;
    CHECK((is - wanted).norm() < 1e-7);
  }
}

TEST_CASE("a path is followed up to where it leaves the arm's reach") {
  // lwa4p: 655 mm from axis 2, 205 mm up; the wrist 75 mm behind the flange, which points along x.
  const RobotModel robot = embedded_robot("lwa4p");
  const Pose from{Vector3d(0.6, 0, 0.205), rotation_by(Vector3d(0, kDegree * 90, 0))};
  const auto q = robot.kinematics->inverse(from, robot.start);
  REQUIRE(q.has_value());
  const auto line =
      ToolLine::between(from, {from.position + Vector3d(0.2, 0, 0), from.orientation});
  const Followed axes = follow(robot, *line, {}, *q);
  REQUIRE(axes.trouble.has_value());
  CHECK(axes.trouble->kind == PathTrouble::Kind::OutOfReach);
  CHECK(axes.trouble->at * 0.2 == doctest::Approx(0.655 + 0.075 - 0.6).epsilon(1e-3));
  CHECK(axes.axes.end() == doctest::Approx(axes.trouble->at));
}

TEST_CASE("a line through a singular place is followed where the axes go on without a jump") {
  const RobotModel robot = embedded_robot("irb120");
  // The flange looks up, and the wrist passes exactly over axis 1, which stands still: the arm
  // leans over to its back.
  const Pose up{Vector3d(0.2, 0, 0.75), Eigen::Quaterniond::Identity()};
  const auto q = robot.kinematics->inverse(up, robot.start);
  REQUIRE(q.has_value());
  const auto over = ToolLine::between(up, {up.position - Vector3d(0.4, 0, 0), up.orientation});
  const Followed leans = follow(robot, *over, {}, *q);
  REQUIRE_FALSE(leans.trouble.has_value());
  CHECK(std::abs(leans.axes.nodes().back().q[0] - (*q)[0]) < 1e-9);

  // θ5 goes from 20° to −20°, θ4 stays: the closed form keeps it where the axes are in line.
  JointVector bent = joints({10, 10, 10, 0, 20, 0});
  const Pose from = robot.kinematics->forward(bent);
  bent[4] = -20 * kDegree;
  const Pose to = robot.kinematics->forward(bent);
  bent[4] = 20 * kDegree;
  const auto line = ToolLine::between(from, to);
  const Followed passes = follow(robot, *line, {}, bent);
  REQUIRE_FALSE(passes.trouble.has_value());
  CHECK(passes.axes.nodes().back().q[4] == doctest::Approx(-20 * kDegree));
  CHECK(std::abs(passes.axes.nodes().back().q[3]) < 1e-9);
}

TEST_CASE("a line that passes axis 1 by 0.05 mm asks it to jump") {
  // 5° of axis 1 there are 0.05 mm · tan 5° = 0.004 mm of the line.
  const RobotModel robot = embedded_robot("irb120");
  const Pose up{Vector3d(0.2, 0.00005, 0.75), Eigen::Quaterniond::Identity()};
  const auto q = robot.kinematics->inverse(up, robot.start);
  REQUIRE(q.has_value());
  const auto past = ToolLine::between(up, {up.position - Vector3d(0.4, 0, 0), up.orientation});
  const Followed jumps = follow(robot, *past, {}, *q);
  REQUIRE(jumps.trouble.has_value());
  CHECK(jumps.trouble->kind == PathTrouble::Kind::Singular);
  CHECK(jumps.trouble->at == doctest::Approx(0.5).epsilon(1e-3));
}

TEST_CASE("the shortest lines, turns and arcs are followed like long ones") {
  for (const std::string& name : arm_names()) {
    CAPTURE(name);
    const RobotModel robot = embedded_robot(name);
    const JointVector start = robot.start + JointVector::Constant(6, 0.1);
    const Pose from = tip_at(robot, start, kTip);
    for (const double size : {1e-8, 1e-6, 2e-5, 1e-4}) {
      CAPTURE(size);
      const auto at = [&](const Vector3d& shift, const Vector3d& turn) {
        return Pose{from.position + size * shift, rotation_by(size * turn) * from.orientation};
      };
      const auto line = ToolLine::between(from, at({1, 2, 3}, {0, 0, 0}));
      const auto turn = ToolLine::between(from, at({0, 0, 0}, {10, -20, 30}));
      const auto arc =
          ToolArc::through(from, at({1, 1, 0}, {0, 0, 0}).position, at({2, 0, 0}, {1, 0, 0}));
      for (const ToolPath* path :
           {static_cast<const ToolPath*>(&*line), static_cast<const ToolPath*>(&*turn),
            static_cast<const ToolPath*>(&*arc)}) {
        const Followed axes = follow(robot, *path, kTip, start);
        REQUIRE_FALSE(axes.trouble.has_value());
        const Worst worst = off_path(robot, *path, kTip, axes.axes);
        CHECK(worst.place < 1e-3 * size + 1e-14);
        CHECK(worst.turn < 0.1 * size + 1e-12);
      }
    }
  }
}

TEST_CASE("a tool that turns far on a short way is followed") {
  for (const char* const name : {"gantry", "irb120"}) {
    CAPTURE(name);
    const RobotModel robot = embedded_robot(name);
    const JointVector start = robot.start + JointVector::Constant(robot.axis_count(), 0.1);
    const Pose tip{Vector3d(-0.002, -0.018, 0), Eigen::Quaterniond::Identity()};
    const Pose from = tip_at(robot, start, tip);
    for (const double way : {1e-5, 1.4e-4, 1e-3}) {
      CAPTURE(way);
      // About the axis of the last joint, which alone turns the tool then.
      const auto line =
          ToolLine::between(from, {from.position + from.orientation * Vector3d(way, 0, 0),
                                   from.orientation * rotation_by(Vector3d(0, 0, 146 * kDegree))});
      const Followed axes = follow(robot, *line, tip, start);
      REQUIRE_FALSE(axes.trouble.has_value());
      const Worst worst = off_path(robot, *line, tip, axes.axes);
      CHECK(worst.place < 1e-6);
      CHECK(worst.turn < 1e-5);
      CHECK(greatest_step(axes.axes) <= 5 * kDegree);
    }
  }
}

TEST_CASE("turns of a spiral and short spans of a spline are not stepped over") {
  const RobotModel robot = embedded_robot("irb120");
  const Pose from = tip_at(robot, robot.start, kTip);
  for (const double turns : {1.0, 8.0, 32.0, 128.0}) {  // a step of an eighth would see whole turns
    CAPTURE(turns);
    const auto spiral = ToolSpiral::inwards(from, from.orientation, 0.01, turns);
    REQUIRE(spiral.has_value());
    const Followed axes = follow(robot, *spiral, kTip, robot.start);
    REQUIRE_FALSE(axes.trouble.has_value());
    CHECK(off_path(robot, *spiral, kTip, axes.axes).place < 1e-6);
  }
  const auto at = [&](double x, double y) {
    return Pose{from.position + from.orientation * Vector3d(x, y, 0), from.orientation};
  };
  const auto spline = ToolSpline::through(
      {from, at(0.05, 0), at(0.051, 0.0005), at(0.05, 0.001), at(0.051, 0.0015), at(0, 0.05)});
  REQUIRE(spline.has_value());
  const Followed axes = follow(robot, *spline, kTip, robot.start);
  REQUIRE_FALSE(axes.trouble.has_value());
  CHECK(off_path(robot, *spline, kTip, axes.axes).place < 1e-6);
}

TEST_CASE("a path of more nodes than there is room for is refused, not begun to be kept") {
  const RobotModel robot = embedded_robot("irb120");
  const Pose from = robot.kinematics->forward(robot.start);
  for (const double turns : {1000.0, 1e9}) {
    const auto spiral = ToolSpiral::inwards(from, from.orientation, 0.01, turns);
    const Followed axes = follow(robot, *spiral, {}, robot.start);
    REQUIRE(axes.trouble.has_value());
    CHECK(axes.trouble->kind == PathTrouble::Kind::TooLong);
    CHECK(axes.axes.nodes().size() <= kMostNodes + 1);
  }
}
