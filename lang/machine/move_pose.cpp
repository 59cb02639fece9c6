#include "lang/machine/move_pose.h"

#include "lang/machine/cartesian_axes.h"

namespace rob::lang {
namespace {

using pose_math::operator+;

bool is_nothing(const PoseValue& pose) {
  const auto& [p, q] = pose;
  return p.x == 0 && p.y == 0 && p.z == 0 && q.i == 0 && q.j == 0 && q.k == 0;
}

PoseValue pose_of(const MoveCommand& command, const PoseValue& last, const PoseValue& frame) {
  const auto& t = command.target;
  const Vector3 place{t[0], t[1], t[2]};
  if (command.relative) {
    return {last.position + pose_math::rotate(frame.rotation, place), last.rotation};
  }
  const PoseValue pose{place, {t[3], t[4], t[5], t[6]}};
  return command.in_frame ? pose_math::compose(frame, pose) : pose;
}

}  // namespace

PoseValue target_pose(const MoveCommand& command, const PoseValue& last, const Setting& setting,
                      const std::vector<RobotSignature::Coordinate>& coordinates) {
  const PoseValue& frame = setting.in_tool ? last : setting.frame;
  if (command.means == MoveCommand::Target::Pose) return pose_of(command, last, frame);
  const PoseValue seen = pose_math::compose(pose_math::inverse(frame), last);
  return pose_math::compose(frame, with_coordinates(coordinates, seen, command));
}

PoseValue flange_for(const PoseValue& tip, const Setting& setting) {
  if (!has_tool(setting)) return tip;  // to the bit
  return pose_math::compose(tip, pose_math::inverse(setting.tool.tip));
}

PoseValue tip_of(const PoseValue& flange, const Setting& setting) {
  if (!has_tool(setting)) return flange;
  return pose_math::compose(flange, setting.tool.tip);
}

bool has_tool(const Setting& setting) { return !is_nothing(setting.tool.tip); }

bool is_plain(const Setting& setting) {
  return !setting.in_tool && is_nothing(setting.frame) && !has_tool(setting);
}

}  // namespace rob::lang
