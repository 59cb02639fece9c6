#include "motion/path/ladder.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "motion/path/free_path.h"
#include "motion/path/goal_rung.h"
#include "motion/path/tool_line.h"
#include "motion/path/value_spline.h"
#include "motion/path/way_cost.h"
#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_library.h"
#include "tests/support/kdl_chain.h"

using namespace rob::motion;
using Eigen::Vector3d;
using rob::test::KdlChain;

namespace {

ToolLine line_by(const Pose& from, const Vector3d& shift) {
  Pose to = from;
  to.position += shift;
  const auto line = ToolLine::between(from, to);
  REQUIRE(line.has_value());
  return *line;
}

/// The sum that a ladder makes least, as the manual has it.
double sum_of(const RobotModel& robot, const std::vector<JointVector>& way) {
  double sum = 0;
  const auto rungs = static_cast<double>(way.size() - 1);
  for (std::size_t k = 1; k < way.size(); ++k) {
    for (int i = 0; i < robot.axis_count(); ++i) {
      const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
      sum += std::pow((way[k][i] - way[k - 1][i]) / axis.v_max, 2) * rungs;
      const double u = (way[k][i] - (axis.max + axis.min) / 2) / ((axis.max - axis.min) / 2);
      sum += 0.01 * (1 / (1 - u * u) - 1);
    }
  }
  return sum;
}

struct Judged {
  double off_line = 0;  ///< m, by KDL's forward kinematics
  double off_z = 0;     ///< by how much the tool's z differs
  double off_turn = 0;  ///< rad
  bool within = true;   ///< limits of the axes
  double apart = 0;     ///< rad: the greatest step of an axis
};

Judged judge(const RobotModel& robot, const ToolLine& line, const JointPath& axes,
             KdlChain oracle) {
  constexpr int kPlaces = 500;
  Judged judged;
  JointVector before = axes.at(0).q;
  for (int k = 0; k <= kPlaces; ++k) {
    const double s = static_cast<double>(k) / kPlaces;
    const JointVector q = axes.at(s).q;
    const Pose is = oracle.forward(q);
    const Pose wanted = line.at(s);
    judged.off_line = std::max(judged.off_line, (is.position - wanted.position).norm());
    const Vector3d z = Vector3d::UnitZ();
    judged.off_z = std::max(judged.off_z, (is.orientation * z - wanted.orientation * z).norm());
    judged.off_turn = std::max(judged.off_turn, is.orientation.angularDistance(wanted.orientation));
    judged.apart = std::max(judged.apart, (q - before).cwiseAbs().maxCoeff());
    for (int i = 0; i < q.size(); ++i) {
      const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
      judged.within = judged.within && q[i] >= axis.min - 1e-9 && q[i] <= axis.max + 1e-9;
    }
    before = q;
  }
  return judged;
}

const FreeTurn kSpin{Freedom::Spin};

}  // namespace

TEST_CASE("a spline of values meets them and is the natural cubic between and beyond them") {
  // 0, 1, 0 at 0, 1, 2: the bend in the middle M follows from 4·M = 6·(−1 − 1).
  const ValueSpline spline({0, 1, 2}, {0, 1, 0});
  CHECK(spline.at(1) == doctest::Approx(1));
  CHECK(spline.at(0.5) == doctest::Approx(0.5 + 3.0 / 16));
  CHECK(spline.at(1.5) == doctest::Approx(0.5 + 3.0 / 16));
  // Beyond the ends with the slope there, 1 + 3/6.
  CHECK(spline.at(-0.1) == doctest::Approx(-0.15));
  CHECK(spline.at(2.1) == doctest::Approx(-0.15));
  const ValueSpline straight({0, 0.3, 1}, {2, 2.6, 4});
  for (const double s : {-0.5, 0.0, 0.1, 0.77, 1.5})
    CHECK(straight.at(s) == doctest::Approx(2 + 2 * s));
}

TEST_CASE("what a choice costs is the time of the axes and the nearness of their limits") {
  const RobotModel robot = embedded_robot("ur5e");
  JointVector q = JointVector::Zero(6);
  CHECK(limit_cost(robot, q) == 0);
  q[0] = robot.axes[0].max / 2;
  CHECK(limit_cost(robot, q) == doctest::Approx(0.01 * (1 / 0.75 - 1)));
  CHECK(way_cost(robot, JointVector::Zero(6), q) ==
        doctest::Approx(std::pow(q[0] / robot.axes[0].v_max, 2)));
  CHECK(axes_within(robot, q));
  q[0] = robot.axes[0].max + 1e-6;
  CHECK_FALSE(axes_within(robot, q));
}

TEST_CASE("of a pose with a free turn that is nearest which needs no turn about the free axis") {
  std::mt19937 random(1);
  std::normal_distribution<double> any;
  for (int i = 0; i < 100; ++i) {
    const auto turn = [&] {
      return Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized();
    };
    const Eigen::Quaterniond from = turn();
    const Pose pose{{1, 2, 3}, turn()};
    const FreeTurn tilted{Freedom::C, Vector3d(any(random), any(random), any(random)).normalized()};
    for (const FreeTurn& free : {kSpin, tilted}) {
      const double least = from.angularDistance(nearest_turn(pose, free, from).orientation);
      for (const double angle : {-2.0, -0.3, 0.001, 1.0, 3.0}) {
        const Pose other = turned(pose, free, angle);
        CHECK(other.position == pose.position);
        CHECK(from.angularDistance(other.orientation) >= least - 1e-9);
        CHECK(nearest_turn(other, free, from)
                  .orientation.angularDistance(nearest_turn(pose, free, from).orientation) < 1e-7);
      }
    }
  }
}

TEST_CASE("no way beside that of a ladder costs less") {
  RobotModel robot = embedded_robot("ur5e");
  robot.axes[5].max = robot.start[5] + 0.2;  // it turns away from there
  robot.axes[5].min = robot.start[5] - 3;
  const ToolLine line = line_by(robot.kinematics->forward(robot.start), {0.03, 0.02, 0});
  const Choice choice = Choice::of_turn(robot, line, {}, kSpin);
  const std::vector<double> places{0, 0.25, 0.5, 0.75, 1};
  const auto holds = Ladder(robot, choice, places, 1).climb(robot.start);
  REQUIRE(holds.size() == places.size());
  const auto sum = [&](const std::vector<double>& angles) {
    std::vector<JointVector> way{robot.start};
    for (std::size_t k = 1; k < angles.size(); ++k) {
      const Pose pose = turned(line.at(places[k]), kSpin, angles[k]);
      const auto q = robot.kinematics->inverse(pose, holds[k].q);
      REQUIRE(q.has_value());
      way.push_back(*q);
    }
    return sum_of(robot, way);
  };
  std::vector<double> angles;
  for (const auto& hold : holds) angles.push_back(hold.value);
  const double least = sum(angles);
  CHECK(least < sum(std::vector<double>(angles.size(), 0)));
  CHECK(angles.back() < -0.1);
  // The grid's last step is 5 deg/64.
  const double step = 5 * rob::kDegree / 64;
  std::mt19937 random(2);
  std::uniform_int_distribution<int> some(-40, 40);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> other = angles;
    for (std::size_t k = 1; k < other.size(); ++k) other[k] += step * some(random);
    CHECK(sum(other) >= least - 1e-12);
  }
  for (std::size_t k = 1; k < angles.size(); ++k) {
    for (const int side : {-1, 1}) {
      std::vector<double> other = angles;
      other[k] += side * step;
      CHECK(sum(other) >= least - 1e-12);
    }
  }
}

TEST_CASE("a line with SPIN stays a line, and the tool's z as it was, by KDL") {
  const RobotModel robot = embedded_robot("ur5e");
  const ToolLine line = line_by(robot.kinematics->forward(robot.start), {0.1, 0.15, -0.05});
  const TurnedPath path = choose_turn(robot, line, {}, kSpin, robot.start);
  const Followed made = follow(robot, path, {}, robot.start);
  REQUIRE_FALSE(made.trouble.has_value());
  const Judged judged = judge(robot, line, made.axes, KdlChain::standard(rob::test::ur5e_table()));
  CHECK(judged.off_line < 1e-6);
  CHECK(judged.off_z < 2e-5);
  CHECK(judged.within);
  CHECK(judged.apart < 0.02);
  CHECK(path.turn() > 0.01);  // it makes use of it
  // The same bits each time.
  const TurnedPath again = choose_turn(robot, line, {}, kSpin, robot.start);
  for (const double s : {0.1, 0.5, 1.0})
    CHECK(again.at(s).orientation.coeffs() == path.at(s).orientation.coeffs());
}

TEST_CASE("a motion that leaves a turn free moves its axes less") {
  const RobotModel robot = embedded_robot("ur5e");
  const ToolLine line = line_by(robot.kinematics->forward(robot.start), {0, 0.15, 0});
  const auto way = [&](const std::optional<FreeTurn>& free) {
    MotionPlanner planner(robot, robot.start);
    MotionRequest request;
    request.free = free;
    const PlanOutcome outcome = planner.plan(request, line);
    REQUIRE(std::holds_alternative<PlannedSegment>(outcome));
    return way_cost(robot, robot.start, std::get<PlannedSegment>(outcome).segment.target);
  };
  CHECK(way(kSpin) < 0.95 * way(std::nullopt));
}

TEST_CASE("a line that seven axes cannot follow with one standing is found, by KDL") {
  const RobotModel robot = embedded_robot("fr3");
  std::mt19937 random(4);
  std::normal_distribution<double> any;
  int more = 0;
  for (int i = 0; i < 12; ++i) {
    JointVector start = robot.start;
    for (double& value : start) value += 0.3 * any(random);
    REQUIRE(axes_within(robot, start));
    const Vector3d way(any(random), any(random), any(random));
    const ToolLine line = line_by(robot.kinematics->forward(start), 0.25 * way.normalized());
    const KdlChain oracle = KdlChain::craig(rob::test::fr3_table());
    const auto good = [&](const Followed& made) {
      return !made.trouble && judge(robot, line, made.axes, oracle).within;
    };
    bool chosen = false;
    const Followed made = follow_choosing(robot, line, {}, start, chosen);
    const bool standing = good(follow(robot, line, {}, start));
    if (standing) CHECK(good(made));
    if (!good(made)) continue;
    const Judged judged = judge(robot, line, made.axes, oracle);
    CHECK(judged.off_line < 1e-6);
    CHECK(judged.off_turn < 2e-5);
    CHECK(judged.apart < 0.02);
    more += chosen && !standing ? 1 : 0;
  }
  CHECK(more > 0);
}

TEST_CASE("seven axes go to a pose on the branch and the value of the spare axis that cost least") {
  const RobotModel robot = embedded_robot("fr3");
  KdlChain oracle = KdlChain::craig(rob::test::fr3_table());
  JointVector q = robot.start;
  q[0] = 0.9;
  q[1] -= 0.3;
  q[6] += 1;
  const Pose pose = robot.kinematics->forward(q);
  const auto found = choose_at_goal(robot, pose, robot.start);
  REQUIRE(found.has_value());
  CHECK((oracle.forward(*found).position - pose.position).norm() < 1e-8);
  CHECK(axes_within(robot, *found));
  const auto cost = [&](const JointVector& to) {
    return way_cost(robot, robot.start, to) + limit_cost(robot, to);
  };
  CHECK(cost(*found) < cost(q));
  // Another search: from the axes found, and from many others, with axis 1 where it is asked for.
  std::mt19937 random(3);
  const int spare = robot.kinematics->spare();
  for (int i = 0; i < 300; ++i) {
    JointVector from = *found;
    for (int k = 0; k < 7; ++k)
      from[k] += std::uniform_real_distribution<double>(-0.4, 0.4)(random);
    const auto other = robot.kinematics->beside(pose, from);
    if (!other || !axes_within(robot, *other)) continue;
    CHECK((*other)[spare] == from[spare]);
    CHECK(cost(*other) > cost(*found) - 0.003);  // between two values there may be a better one
  }
}
