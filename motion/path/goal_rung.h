#pragma once

#include <optional>

#include "motion/robots/robot_model.h"
#include "motion/space/joint_vector.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// The axis values that bring the flange to a pose, of a robot with a spare axis: of all branches,
/// each at 72 evenly spread values of that axis, those with the least way_cost from `near` and
/// limit_cost, the first of equals. None where none are within the limits, and of other robots.
std::optional<JointVector> choose_at_goal(const RobotModel& robot, const Pose& pose,
                                          const JointVector& near) noexcept;

}  // namespace rob::motion
