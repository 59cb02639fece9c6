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

}  // namespace rob::motion
