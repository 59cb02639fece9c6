#pragma once

#include "lang/values/arithmetic.h"
#include "lang/values/pose_math.h"
#include "lang/values/setting.h"
#include "lang/values/units.h"

/// How a pose lies in the slots of the Vm: x y z in mm, then w i j k.
namespace rob::lang {

inline constexpr int kPoseSlots = 7;
inline constexpr int kCapsuleSlots = 7;  ///< from, to, radius in mm
/// A TOOL: its pose, mass in kg, centre of gravity in mm, and its capsules.
inline constexpr int kShapeSlot = 11;
inline constexpr int kToolSlots = kShapeSlot + kCapsuleSlots * static_cast<int>(kMostToolCapsules);

inline Vector3 load_vector(const Slot* slots) {
  return {slots[0].real, slots[1].real, slots[2].real};
}

inline PoseValue load_pose(const Slot* slots) {
  return {load_vector(slots), {slots[3].real, slots[4].real, slots[5].real, slots[6].real}};
}

/// A place in mm, in m.
inline Vector3 to_si(const Vector3& place) noexcept {
  return {to_si(place.x, kLength), to_si(place.y, kLength), to_si(place.z, kLength)};
}
inline PoseValue to_si(const PoseValue& pose) noexcept {
  return {to_si(pose.position), pose.rotation};
}
/// A place in m, in mm.
inline Vector3 from_si(const Vector3& place) noexcept {
  return {from_si(place.x, kLength), from_si(place.y, kLength), from_si(place.z, kLength)};
}
inline PoseValue from_si(const PoseValue& pose) noexcept {
  return {from_si(pose.position), pose.rotation};
}

/// In SI, as a Machine takes it.
inline CapsuleValue load_capsule(const Slot* slots) {
  return {to_si(load_vector(slots)), to_si(load_vector(slots + 3)), to_si(slots[6].real, kLength)};
}
inline ToolValue load_tool(const Slot* slots) {
  ToolValue tool{to_si(load_pose(slots)), slots[kPoseSlots].real,
                 to_si(load_vector(slots + kPoseSlots + 1))};
  const Slot* capsule = slots + kShapeSlot;
  for (CapsuleValue& one : tool.shape) {
    one = load_capsule(capsule);
    capsule += kCapsuleSlots;
  }
  return tool;
}

inline void store(const Vector3& vector, Slot* slots) {
  slots[0].real = vector.x;
  slots[1].real = vector.y;
  slots[2].real = vector.z;
}

inline void store(const PoseValue& pose, Slot* slots) {
  store(pose.position, slots);
  slots[3].real = pose.rotation.w;
  slots[4].real = pose.rotation.i;
  slots[5].real = pose.rotation.j;
  slots[6].real = pose.rotation.k;
}

}  // namespace rob::lang
