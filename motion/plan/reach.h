#pragma once

#include <optional>

#include "motion/robots/robot_model.h"
#include "motion/space/joint_vector.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// The middle of every axis' range.
JointVector middle(const RobotModel& robot) noexcept;

/// The axis values for a pose: those nearest to `near`, or, where they are beyond a limit, those
/// nearest to the middle of the ranges; where both are, the former. None if there are none. The
/// robot needs kinematics.
std::optional<JointVector> reach(const RobotModel& robot, const Pose& pose,
                                 const JointVector& near) noexcept;

}  // namespace rob::motion
