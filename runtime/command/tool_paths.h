#pragma once

#include <memory>
#include <variant>
#include <vector>

#include "lang/machine/motion_words.h"
#include "motion/path/tool_path.h"
#include "motion/robots/robot_model.h"
#include "runtime/words/messages.h"

namespace rob::runtime {

/// A path of the tip, or why there is none.
using ToolPathOrWords = std::variant<std::unique_ptr<motion::ToolPath>, Words>;

/// MOVES through joints: from the first through those between to the last. `tip`: of the tool,
/// seen from the flange.
ToolPathOrWords joints_through(const motion::RobotModel& robot, const motion::Pose& tip,
                               const std::vector<motion::JointVector>& points);

/// MOVEL … EULER.
ToolPathOrWords euler_line(const motion::Pose& from, const motion::Pose& to);

/// MOVEL, MOVEC, MOVES: from the first point through those between to the last, in the world.
ToolPathOrWords path_through(lang::MotionKind kind, const std::vector<motion::Pose>& points);

/// SPIRAL from where the tip is. `frame`: the active one, in the world.
ToolPathOrWords spiral_from(const motion::Pose& from, const motion::Pose& frame, double radius,
                            double turns);

}  // namespace rob::runtime
