#pragma once

#include "lang/machine/reading.h"
#include "lang/values/arithmetic.h"
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

inline Eigen::Vector3d eigen_of(const lang::Vector3& place) { return {place.x, place.y, place.z}; }

inline motion::Pose to_motion(const lang::PoseValue& pose) {
  const auto& [place, turn] = pose;
  return {Eigen::Vector3d(place.x, place.y, place.z),
          Eigen::Quaterniond(turn.w, turn.i, turn.j, turn.k)};
}

/// The values that force, torque and WRENCH() read, N and Nm.
inline void store_wrench(lang::Reading what, const Eigen::Vector3d& force,
                         const Eigen::Vector3d& torque, lang::Slot* value) noexcept {
  if (what != lang::Reading::Torque)
    for (const double part : force) (value++)->real = part + 0.0;
  if (what != lang::Reading::Force)
    for (const double part : torque) (value++)->real = part + 0.0;
}

}  // namespace rob::runtime
