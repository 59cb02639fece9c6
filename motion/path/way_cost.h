#pragma once

#include "motion/robots/robot_model.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The cost of one choice among axis values beside another: how far the axes go, and how near to
/// their limits they are.

/// Sum over the axes of (Δq/v_max)², s².
double way_cost(const RobotModel& robot, const JointVector& from, const JointVector& to) noexcept;
/// 0.01·Σ(1/(1 − u²) − 1) with u the place within the limits, −1 … 1; large beyond them.
double limit_cost(const RobotModel& robot, const JointVector& q) noexcept;
/// Whether every axis is within its limits.
bool axes_within(const RobotModel& robot, const JointVector& q) noexcept;

}  // namespace rob::motion
