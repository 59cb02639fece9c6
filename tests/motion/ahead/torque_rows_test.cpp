// Under the look-ahead law no gear of an arm is asked for more than it bears. Judged by the
// references that are handed out: their differences in Lagrange's equations, with kinetic and
// potential energy alone.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "motion/path/tool_line.h"
#include "motion/plan/torque_share.h"
#include "tests/motion/generate/look_ahead_run.h"
#include "tests/support/degrees.h"

using namespace rob::motion;
using rob::test::kDegree;
using rob::test::LookAheadRun;

namespace {

using Targets = std::vector<std::array<double, 6>>;

/// The UMS-7 under the look-ahead law, with references every 4 ms and gears that bear so much (Nm).
RobotModel geared_arm(const std::array<double, 6>& torque_max) {
  RobotModel robot = embedded_robot("ums7");
  robot.law = Law::LookAhead;
  robot.reference_period = 0.004;
  for (std::size_t i = 0; i < 6; ++i) robot.mechanics->motors[i].torque_max = torque_max[i];
  return robot;
}

constexpr std::array<double, 6> kStrong{300, 300, 150, 30, 30, 10};
/// Weight takes 2.4 Nm of axes 2 to 5; without a limit the tour below asks for 1.5 times as much.
constexpr std::array<double, 6> kWeak{18, 16, 8, 3.2, 3.2, 0.05};

/// Joint motions with corners and stops.
struct Tour : LookAheadRun {
  explicit Tour(const RobotModel& robot, const ArmLoad& load = {}) : LookAheadRun(robot) {
    planner().carry(load);
    const Targets targets{{60, 20, -30, 40, -30, 90},
                          {-20, 30, 10, -60, -40, 0},
                          {40, -10, -40, 30, 10, 60},
                          {0, 25, -20, 0, -60, -90}};
    for (const auto& degrees : targets) {
      JointVector q = this->robot().start;
      for (int i = 0; i < 6; ++i) q[i] += degrees[static_cast<std::size_t>(i)] * kDegree;
      push(std::get<PlannedSegment>(planner().plan(rob::test::move_to(q))).segment);
    }
    stop();
    close();
    finish();
  }
};

/// Lines of the tool around a rectangle, as fast as the axes can.
struct Frame : LookAheadRun {
  explicit Frame(const RobotModel& robot) : LookAheadRun(robot) {
    for (const auto& [x, y] : std::array<std::array<double, 2>, 4>{
             {{0, 0.25}, {-0.25, 0.25}, {-0.25, -0.25}, {0, -0.25}}}) {
      Pose to = start_pose();
      to.position += Eigen::Vector3d(x, y, 0);
      const auto path = ToolLine::between(planner().tool_pose(), to).value();
      push(std::get<PlannedSegment>(planner().plan(MotionRequest{}, path)).segment);
    }
    stop();
    close();
    finish();
  }
  Pose start_pose() const { return robot().kinematics->forward(robot().start); }
};

/// ∂f/∂x_i of a function of six values.
template <typename Function>
JointVector slopes_of(const Function& f, const JointVector& x) {
  constexpr double kStep = 1e-5;
  JointVector slopes(6);
  for (int i = 0; i < 6; ++i) {
    JointVector more = x;
    JointVector less = x;
    more[i] += kStep;
    less[i] -= kStep;
    slopes[i] = (f(more) - f(less)) / (2 * kStep);
  }
  return slopes;
}

/// Greatest |P|/torque_max over all references, of an arm that they were not planned for, too.
double worst_torque(const LookAheadRun& run, const ArmMechanics& arm) {
  const auto& rows = run.samples();
  const double T = run.robot().reference_period;
  const auto q = [&](std::size_t k) { return rows[k].reference.q; };
  const auto qd = [&](std::size_t k) -> JointVector { return (q(k + 1) - q(k - 1)) / (2 * T); };
  const Ums7Dynamics& dynamics = arm.dynamics;
  const auto impulse = [&](std::size_t k) {
    return slopes_of([&](const JointVector& v) { return dynamics.kinetic_energy(q(k), v); }, qd(k));
  };
  double worst = 0;
  for (std::size_t k = 2; k + 2 < rows.size(); ++k) {
    const JointVector v = qd(k);
    const JointVector P =
        (impulse(k + 1) - impulse(k - 1)) / (2 * T) -
        slopes_of([&](const JointVector& x) { return dynamics.kinetic_energy(x, v); }, q(k)) +
        slopes_of([&](const JointVector& x) { return dynamics.potential(x); }, q(k));
    for (int i = 0; i < 6; ++i)
      worst = std::max(worst, std::abs(P[i]) / arm.motors[static_cast<std::size_t>(i)].torque_max);
  }
  return worst;
}

double took(const LookAheadRun& run) { return run.events().back().time; }

/// Dense chords of an arc, which become a curve.
struct Chords : LookAheadRun {
  explicit Chords(const RobotModel& robot) : LookAheadRun(robot) {
    const Pose start = this->robot().kinematics->forward(this->robot().start);
    constexpr double kRadius = 0.2;
    for (int k = 1; k <= 120; ++k) {
      const double angle = k * 1.5 * kDegree;
      Pose to = start;
      to.position += kRadius * Eigen::Vector3d(std::cos(angle) - 1, std::sin(angle), 0);
      const auto path = ToolLine::between(planner().tool_pose(), to).value();
      while (buffer().room() < 2) step();
      push(std::get<PlannedSegment>(planner().plan(MotionRequest{}, path)).segment);
    }
    while (buffer().room() < 2) step();
    stop();
    close();
    finish();
  }
};

/// The strong arm asks for too much of the weak one's gears, which keep within them and use them.
template <typename Run>
void check_gears(RobotModel strong, RobotModel weak) {
  const Run fast(strong);
  const Run slow(weak);
  const ArmMechanics& judged = *weak.mechanics;
  CHECK(worst_torque(fast, judged) > 1.1);
  CHECK(worst_torque(slow, judged) < TorqueShare::kMost + 0.02);
  CHECK(worst_torque(slow, judged) > 0.6);
  CHECK(took(slow) > took(fast));
}

RobotModel without_jerk(RobotModel robot) {
  for (Axis& axis : robot.axes) axis.j_max = std::numeric_limits<double>::infinity();
  return robot;
}

}  // namespace

TEST_CASE("joint motions under the look-ahead law ask no gear for more than it bears") {
  check_gears<Tour>(geared_arm(kStrong), geared_arm(kWeak));
  check_gears<Tour>(without_jerk(geared_arm(kStrong)), without_jerk(geared_arm(kWeak)));
}

TEST_CASE("lines of the tool under the look-ahead law ask no gear for more than it bears") {
  check_gears<Frame>(geared_arm(kStrong), geared_arm(kWeak));
  check_gears<Frame>(without_jerk(geared_arm(kStrong)), without_jerk(geared_arm(kWeak)));
  check_gears<Chords>(geared_arm(kStrong), geared_arm({5, 5, 4, 3, 3, 0.02}));
}

TEST_CASE("a load makes motions under the look-ahead law as slow as its gears need") {
  const RobotModel robot = geared_arm({40, 160, 90, 30, 30, 10});
  const ArmLoad load = ArmLoad::point(10, {0, 0, 0.05});
  const Tour bare(robot);
  const Tour loaded(robot, load);
  const ArmMechanics carrying = robot.mechanics->carrying(load);
  CHECK(worst_torque(bare, carrying) > 1);
  CHECK(worst_torque(loaded, carrying) < TorqueShare::kMost + 0.02);
  CHECK(took(loaded) > took(bare));
}

TEST_CASE("no drive of an arm is asked for more than it has under the look-ahead law") {
  const RobotModel strong = geared_arm(kStrong);
  RobotModel weak = strong;
  constexpr std::array<double, 6> kForces{110, 90, 35, 9, 9, 2};
  for (std::size_t i = 0; i < 6; ++i) weak.axes[i].drive.force_max = kForces[i];
  const auto most = [&](const LookAheadRun& run) {
    double share = 0;
    for (const GeneratorSample& sample : run.samples()) {
      const JointReference& r = sample.reference;
      share = std::max(share, torque_share(weak, r.q, r.qd, r.qdd).share);
    }
    return share;
  };
  const Tour fast(strong);
  const Tour slow(weak);
  CHECK(most(fast) > 1.1);
  CHECK(most(slow) < TorqueShare::kMost + 0.02);
  CHECK(most(slow) > 0.6);
  CHECK(took(slow) > took(fast));
}

TEST_CASE("gears that are strong enough change nothing of a path") {
  const Tour usual(geared_arm(kStrong));
  const Tour stronger(geared_arm({1e6, 1e6, 1e6, 1e6, 1e6, 1e6}));
  REQUIRE(usual.samples().size() == stronger.samples().size());
  for (std::size_t k = 0; k < usual.samples().size(); ++k)
    CHECK(usual.samples()[k].reference.q == stronger.samples()[k].reference.q);
}

TEST_CASE("a motion whose weight alone is too much is refused with its axis and place") {
  const RobotModel robot = geared_arm({300, 300, 150, 30, 1.5, 10});
  MotionPlanner planner(robot, robot.start);
  // Axis 5 bears 2.35 Nm·sin of what the hand is off the plumb: 1.5 Nm at 39.7 degrees.
  JointVector q = robot.start;
  q[4] -= 60 * kDegree;
  const auto outcome = planner.plan(rob::test::move_to(q));
  const auto* const refusal = std::get_if<Refusal>(&outcome);
  REQUIRE(refusal != nullptr);
  CHECK(refusal->kind == Refusal::Kind::TooHeavy);
  CHECK(refusal->axis == 4);
  CHECK(refusal->limit == 1.5);
  CHECK(std::abs(refusal->at / refusal->way * 60 - std::asin(1.5 / 2.35) / kDegree) < 2);
}
