#pragma once

#include "lang/move_command.h"
#include "lang/pose_math.h"

namespace rob::lang {

/// Where a motion with Target::Pose brings the tool; `last`: where the one before it does.
inline PoseValue target_pose(const MoveCommand& command, const PoseValue& last) {
  const auto& t = command.target;
  const Vector3 place{t[0], t[1], t[2]};
  if (!command.relative) return {place, {t[3], t[4], t[5], t[6]}};
  const Vector3& from = last.position;
  return {{from.x + place.x, from.y + place.y, from.z + place.z}, last.rotation};
}

}  // namespace rob::lang
