#pragma once

#include "lang/values/pose_math.h"
#include "motion/space/pose.h"

/// Poses between the language, which keeps their parts, and motion, which computes with Eigen's.
namespace rob::runtime {

inline lang::PoseValue to_lang(const motion::Pose& pose) noexcept {
  const Eigen::Vector3d& place = pose.position;
  const Eigen::Quaterniond& turn = pose.orientation;
  // + 0.0: the language knows no -0.
  return {{place.x() + 0.0, place.y() + 0.0, place.z() + 0.0},
          {turn.w() + 0.0, turn.x() + 0.0, turn.y() + 0.0, turn.z() + 0.0}};
}

inline motion::Pose to_motion(const lang::PoseValue& pose) {
  const auto& [place, turn] = pose;
  return {Eigen::Vector3d(place.x, place.y, place.z),
          Eigen::Quaterniond(turn.w, turn.i, turn.j, turn.k)};
}

}  // namespace rob::runtime
