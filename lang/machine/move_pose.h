#pragma once

#include <vector>

#include "lang/machine/move_command.h"
#include "lang/machine/robot_signature.h"
#include "lang/values/pose_math.h"
#include "lang/values/setting.h"

namespace rob::lang {

/// Where a motion with a target of coordinates or of a pose brings the tip of the tool, in the
/// world; `last`: where the one before it does, with the same tool. A component that a tuple leaves
/// out keeps its value, seen from the setting's frame.
PoseValue target_pose(const MoveCommand& command, const PoseValue& last, const Setting& setting,
                      const std::vector<RobotSignature::Coordinate>& coordinates);

/// The pose of the flange that brings the tip of the tool to `tip`, and the other way round.
PoseValue flange_for(const PoseValue& tip, const Setting& setting);
PoseValue tip_of(const PoseValue& flange, const Setting& setting);

/// Whether the tip is another place than the flange.
bool has_tool(const Setting& setting);
/// Whether tuples are what they are without WITH and IN.
bool is_plain(const Setting& setting);

}  // namespace rob::lang
