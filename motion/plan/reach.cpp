#include "motion/plan/reach.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/unit_factors.h"
#include "motion/kinematics/chain_kinematics.h"
#include "motion/path/goal_rung.h"
#include "motion/path/way_cost.h"
#include "motion/plan/feasibility.h"

namespace rob::motion {
namespace {

bool within_limits(const RobotModel& robot, const JointVector& q) noexcept {
  std::array<double, kMaxJoints> target{};
  for (int i = 0; i < robot.axis_count(); ++i) target[static_cast<std::size_t>(i)] = q[i];
  return !check_target(robot, 0xff, target);
}

/// Rotary axes beyond a limit, turned back by as few whole turns as bring them below it.
JointVector turned_within(const RobotModel& robot, JointVector q) noexcept {
  for (int i = 0; i < robot.axis_count(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    if (axis.kind != AxisKind::Rotary) continue;
    const double above = q[i] - axis.max - kLimitTolerance;
    const double below = axis.min - kLimitTolerance - q[i];
    if (above > 0) q[i] -= kFullTurn * std::ceil(above / kFullTurn);
    if (below > 0) q[i] += kFullTurn * std::ceil(below / kFullTurn);
  }
  return q;
}

/// The way of the axes, each counted in the time that its full speed takes.
double square_of_time(const RobotModel& robot, const JointVector& q,
                      const JointVector& near) noexcept {
  double sum = 0;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const double time = (q[i] - near[i]) / robot.axes[static_cast<std::size_t>(i)].v_max;
    sum += time * time;
  }
  return sum;
}

constexpr int kTurns = 72;
/// [choice] Where solutions are searched for, at every twelfth turn: 60 deg apart.
constexpr int kApart = 12;

/// Whether solutions() searches, which takes a thousand times as long as beside().
bool searches(const RobotModel& robot) noexcept {
  const auto* const chain = dynamic_cast<const ChainKinematics*>(robot.kinematics.get());
  return chain != nullptr && !chain->closed();
}

/// The solutions for a pose that go on from those for one beside it.
InverseSolutions beside(const Kinematics& kinematics, const Pose& pose,
                        const InverseSolutions& from) noexcept {
  InverseSolutions found;
  for (const JointVector& near : from)
    if (const auto q = kinematics.beside(pose, near))
      found.q[static_cast<std::size_t>(found.count++)] = *q;
  return found;
}

}  // namespace

JointVector middle(const RobotModel& robot) noexcept {
  JointVector q(robot.axis_count());
  for (int i = 0; i < robot.axis_count(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    q[i] = (axis.min + axis.max) / 2;
  }
  return q;
}

std::optional<JointVector> reach(const RobotModel& robot, const Pose& pose,
                                 const JointVector& near) noexcept {
  if (const auto chosen = choose_at_goal(robot, pose, near)) return chosen;
  std::optional<JointVector> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const JointVector& solution : robot.kinematics->solutions(pose, near)) {
    const JointVector q = turned_within(robot, solution);
    const double distance = square_of_time(robot, q, near);
    if (!(distance < least) || !within_limits(robot, q)) continue;
    least = distance;
    nearest = q;
  }
  return nearest ? nearest : robot.kinematics->inverse(pose, near);
}

bool is_branch_of(const RobotModel& robot, const JointVector& q, const JointVector& near) noexcept {
  constexpr double kSame = 1e-4;  // m, rad. [choice] far above rounding, far below a branch
  const Pose flange = robot.kinematics->forward(q);
  JointVector from = near;
  const int spare = robot.kinematics->spare();
  if (spare >= 0) from[spare] = q[spare];
  const auto nearest =
      spare >= 0 ? robot.kinematics->inverse(flange, from) : reach(robot, flange, near);
  return nearest && (*nearest - q).cwiseAbs().maxCoeff() <= kSame;
}

std::optional<RobotModel> leaving(const RobotModel& robot, const FreeTurn& free, const Pose& tip) {
  auto kinematics = robot.kinematics->leaving(free.kind, tip);
  if (kinematics == nullptr) return std::nullopt;
  RobotModel other = robot;
  other.kinematics = std::move(kinematics);
  return other;
}

std::optional<JointVector> reach_freely(const RobotModel& robot, const Pose& pose, const Pose& tip,
                                        const FreeTurn& free, const JointVector& near) {
  if (const auto other = leaving(robot, free, tip)) {
    auto q = reach(*other, pose, near);
    return q && within_limits(robot, *q) ? q : std::nullopt;
  }
  const Pose now = composed(robot.kinematics->forward(near), tip);
  const Pose first = nearest_turn(pose, free, now.orientation);
  const Pose flange = inverse(tip);
  std::optional<JointVector> best;
  double least = std::numeric_limits<double>::infinity();
  const bool searching = searches(robot);
  InverseSolutions found;
  for (int k = 0; k < kTurns; ++k) {
    const Pose place = composed(turned(first, free, k * kFullTurn / kTurns), flange);
    found = k % kApart == 0 || !searching ? robot.kinematics->solutions(place, near)
                                          : beside(*robot.kinematics, place, found);
    for (const JointVector& solution : found) {
      const JointVector q = turned_within(robot, solution);
      if (!within_limits(robot, q)) continue;
      const double cost = way_cost(robot, near, q) + limit_cost(robot, q);
      if (!(cost < least)) continue;
      least = cost;
      best = q;
    }
  }
  return best;
}

}  // namespace rob::motion
