#pragma once

#include <optional>
#include <span>

#include "lang/machine/move_command.h"
#include "lang/values/setting.h"
#include "motion/robots/robot_model.h"
#include "runtime/words/messages.h"

/// Between poses of a tool and axis values. SI.
namespace rob::runtime {

motion::JointVector joints_of(std::span<const double> axes);

/// Where axis values bring the tip: the pose as `setting` speaks of it.
lang::PoseValue tool_at(const motion::RobotModel& robot, const motion::JointVector& q,
                        const lang::Setting& setting);

/// Axis values for a pose, of all that reach it those nearest to `near`; or why there are none.
/// `free`: what of the pose is left open.
std::optional<Words> axes_for(const motion::RobotModel& robot, const lang::PoseValue& pose,
                              const lang::Setting& setting, const motion::JointVector& near,
                              std::span<double> joints,
                              const std::optional<motion::FreeTurn>& free = std::nullopt);

/// The turn that a motion leaves open; `frame`: that which it is in, where its target has none of
/// its own.
std::optional<motion::FreeTurn> free_turn_of(const lang::MoveCommand& command,
                                             const motion::Pose& frame);

/// Whether the target is a whole pose, with a c of its own that counts.
bool says_whole(const lang::MoveCommand& command);
/// A whole pose must have the c that its place gives, where the axes leave that to it.
std::optional<Words> words_against_c(const motion::RobotModel& robot, const lang::PoseValue& pose,
                                     const lang::PoseValue& reached);

/// A motion to a pose becomes one to the axis values that bring the tool there; or why there are
/// none. `near`: where the axes come from; `free`: what of the pose is left open.
std::optional<Words> settle_on_axes(const motion::RobotModel& robot, const lang::PoseValue& pose,
                                    const motion::JointVector& near, lang::MoveCommand& command,
                                    const lang::Setting& setting = {},
                                    const std::optional<motion::FreeTurn>& free = std::nullopt);

}  // namespace rob::runtime
