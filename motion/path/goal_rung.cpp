#include "motion/path/goal_rung.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/path/choice.h"
#include "motion/path/way_cost.h"

namespace rob::motion {

namespace {

/// rad or m: branches that are nearer are one.
constexpr double kOneBranch = 1e-6;
/// rad or m: who turns farther in one step may have come to another branch.
constexpr double kOneValue = 0.35;

class GoalRung {
 public:
  GoalRung(const RobotModel& robot, const Pose& pose, const JointVector& near) noexcept
      : robot_(robot), pose_(pose), near_(near), axis_(robot.kinematics->spare()) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(axis_)];
    apart_ = spread_of(axis) / kSpreadValues;
  }

  std::optional<JointVector> best() noexcept {
    for (const JointVector& q : robot_.kinematics->solutions(pose_, near_)) look_along(q);
    return best_;
  }

 private:
  /// All values of the axis that can be reached on the branch of one solution.
  void look_along(const JointVector& solution) noexcept {
    const double place = std::round((solution[axis_] - near_[axis_]) / apart_);
    const auto first = at(place, solution);
    if (!first) {
      consider(solution);  // between two values
      return;
    }
    for (int i = 0; i < known_; ++i)
      if ((branches_[static_cast<std::size_t>(i)] - *first).cwiseAbs().maxCoeff() < kOneBranch)
        return;
    for (const double step : {1.0, -1.0}) {
      auto q = first;
      for (double k = place; q && axes_within(robot_, *q); q = at(k += step, *q)) {
        consider(*q);
        remember(*q);
      }
    }
  }

  std::optional<JointVector> at(double value, JointVector q) const noexcept {
    const JointVector from = q;
    q[axis_] = near_[axis_] + value * apart_;
    const auto found = robot_.kinematics->beside(pose_, q);
    if (!found || (*found - from).cwiseAbs().maxCoeff() > kOneValue) return std::nullopt;
    return found;
  }

  void consider(const JointVector& q) noexcept {
    if (!axes_within(robot_, q)) return;
    const double cost = way_cost(robot_, near_, q) + limit_cost(robot_, q);
    if (!(cost < least_)) return;
    least_ = cost;
    best_ = q;
  }

  void remember(const JointVector& q) noexcept {
    if (known_ < static_cast<int>(branches_.size()))
      branches_[static_cast<std::size_t>(known_++)] = q;
  }

  const RobotModel& robot_;
  const Pose& pose_;
  const JointVector& near_;
  int axis_;
  double apart_ = 0;
  std::array<JointVector, 1024> branches_;  ///< places on them that were looked at
  int known_ = 0;
  double least_ = std::numeric_limits<double>::infinity();
  std::optional<JointVector> best_;
};

}  // namespace

std::optional<JointVector> choose_at_goal(const RobotModel& robot, const Pose& pose,
                                          const JointVector& near) noexcept {
  if (robot.kinematics->spare() < 0) return std::nullopt;
  return GoalRung(robot, pose, near).best();
}

}  // namespace rob::motion
