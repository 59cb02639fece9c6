#pragma once

#include <optional>

#include "motion/robots/robot_model.h"
#include "motion/space/joint_vector.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// The middle of every axis' range.
JointVector middle(const RobotModel& robot) noexcept;

/// The axis values for a pose: of all within the limits those nearest to `near`, as the sum over
/// the axes of (way/v_max)²; a spare axis is chosen for them (choose_at_goal). Where none are
/// within the limits, those nearest to `near`. None if there are none.
std::optional<JointVector> reach(const RobotModel& robot, const Pose& pose,
                                 const JointVector& near) noexcept;

/// The same for the tip of a tool, which `tip` places on the flange, with a turn of it left open:
/// of all solutions at 72 evenly spread angles that with the least cost, the first of equals:
/// Σ (Δq/v_max)² + 0.01·Σ (1/(1 − u²) − 1), where u is the place of an axis within its limits, from
/// −1 to 1. The angles begin at the turn that is nearest to the tool's at `near`. Where the axes
/// leave a part of a pose open themselves, the free turn takes its place, and nothing is spread.
/// None where nothing is within the limits.
std::optional<JointVector> reach_freely(const RobotModel& robot, const Pose& pose, const Pose& tip,
                                        const FreeTurn& free, const JointVector& near);

/// Whether of all axis values that bring the flange to where q does those nearest to `near` are q.
bool is_branch_of(const RobotModel& robot, const JointVector& q, const JointVector& near) noexcept;

/// The robot with another part of a pose left open, and the tip of its tool as its flange, where
/// its axes leave a part of a pose open themselves; none of others.
std::optional<RobotModel> leaving(const RobotModel& robot, const FreeTurn& free, const Pose& tip);

}  // namespace rob::motion
