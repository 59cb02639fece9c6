#pragma once

#include <optional>

#include "base/unit_factors.h"
#include "motion/path/tool_path.h"
#include "motion/robots/robot_model.h"
#include "motion/space/joint_vector.h"
#include "motion/space/pose.h"

/// Whole poses on robots whose axes leave a part of them to the place.
namespace rob::motion {

/// The axis values that meet all of a pose, chosen as reach() does; none where there are none
/// within the limits, and of robots whose axes leave nothing open.
std::optional<JointVector> reach_whole(const RobotModel& robot, const Pose& pose,
                                       const JointVector& near);

/// The robot with nothing left open, for a path on which the tool points straight up or down
/// (within 0.01°) all the way: there the last axis alone turns it, so that whole poses can be met.
/// None of other paths, and of robots whose axes leave nothing open.
std::optional<RobotModel> upright_along(const RobotModel& robot, const ToolPath& path);

/// The robot with the tip of a tool, seen from its flange, as its flange: what the axes leave to
/// the place turns about the tip, not about the flange. None where the tip is the flange, and of
/// robots whose axes leave nothing open.
std::optional<RobotModel> tip_as_flange(const RobotModel& robot, const Pose& tip);

/// Whether the axes leave a part of poses to the place, and by how much at most a whole pose may
/// differ from what they make of it, rad.
bool leaves_open(const RobotModel& robot) noexcept;
inline constexpr double kOtherTurn = 0.01 * kDegree;

}  // namespace rob::motion
