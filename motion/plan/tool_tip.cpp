#include "motion/plan/tool_tip.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/unit_factors.h"
#include "motion/plan/feasibility.h"

namespace rob::motion {

namespace {

/// The greatest speed that the linear axes make together.
double linear_speed(const RobotModel& robot) {
  double squares = 0;
  for (const Axis& axis : robot.axes)
    if (axis.kind == AxisKind::Linear) squares += axis.v_max * axis.v_max;
  return std::sqrt(squares);
}

}  // namespace

ToolTip::ToolTip(const RobotModel& robot) noexcept
    : robot_(robot), arms_(JointVector::Zero(robot.axis_count())) {
  set({});
}

void ToolTip::set(const Pose& tip) noexcept {
  tip_ = tip;
  greatest_speed_ = linear_speed(robot_);
  for (int i = 0; i < robot_.axis_count(); ++i) {
    const double arm = robot_.kinematics->lever(i, tip.position);
    arms_[i] = arm > kLimitTolerance ? arm : 0;
    greatest_speed_ += arms_[i] * robot_.axes[static_cast<std::size_t>(i)].v_max;
  }
}

LegDemand ToolTip::demand(const JointVector& from, const JointVector& to) const noexcept {
  LegDemand demand;
  demand.rates = (to - from).cwiseAbs();
  demand.way = demand.pace_way = distance(from, to);
  for (int i = 0; i < robot_.axis_count(); ++i) {
    if (robot_.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary)
      demand.pace_turn = std::max(demand.pace_turn, demand.rates[i]);
  }
  demand.turn = demand.pace_turn;
  demand.farthest = greatest_way(from, to);
  demand.leaving = leaving_speed(from, to);
  return demand;
}

/// The longest way it can cover: the way of the linear axes, and what it swings around the others.
double ToolTip::greatest_way(const JointVector& from, const JointVector& to) const noexcept {
  double squares = 0;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    const double way = to[i] - from[i];
    if (robot_.axes[static_cast<std::size_t>(i)].kind == AxisKind::Linear) squares += way * way;
  }
  return std::sqrt(squares) + swing(from, to);
}

/// Per unit of the leg.
double ToolTip::leaving_speed(const JointVector& from, const JointVector& to) const noexcept {
  constexpr double kStep = 1e-5;  // of the leg: the error is as small beside the speed
  const JointVector before = to - kStep * (to - from);
  return (place_at(to) - place_at(before)).norm() / kStep;
}

/// By Simpson's rule, and by parabolas through the samples.
void ToolTip::measure_swing(const JointVector& from, const JointVector& to,
                            LegDemand& demand) const {
  if (swing(from, to) == 0) return;
  constexpr double kStep = 1e-4;            // of the leg, for differences
  constexpr double kApart = 2.5 * kDegree;  // [choice] cosines bend little between
  const JointVector way = to - from;
  const auto speed = [&](double s) {
    const JointVector step = way * kStep;
    const JointVector q = from + way * s;
    return (place_at(q + step) - place_at(q - step)).norm() / (2 * kStep);
  };
  const int half = 4 + static_cast<int>(demand.turn / kApart / 2);
  double a = 0;
  double b = 0;
  double sum = 0;
  double greatest = 0;
  for (int k = 0; k <= 2 * half; ++k) {
    const double c = speed(k / (2.0 * half));
    const bool end = k == 0 || k == 2 * half;
    sum += c * (end ? 1 : k % 2 == 1 ? 4 : 2);
    greatest = std::max(greatest, c);
    if (k >= 2 && b > a && b >= c)
      greatest = std::max(greatest, b + (a - c) * (a - c) / (8 * (2 * b - a - c)));
    a = std::exchange(b, c);
  }
  demand.way = sum / (6 * half);
  demand.pace_way = greatest;
}

}  // namespace rob::motion
