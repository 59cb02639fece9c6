#include "lang/machine/seen_from.h"

#include "lang/values/pose_slots.h"
#include "lang/values/units.h"

namespace rob::lang {

void turn_into_frame(Reading what, const Setting& setting, const PoseValue& tool, Slot* value) {
  if (!needs_sensor(what)) return;
  const PoseValue& frame = setting.in_tool ? tool : setting.frame;
  const Quaternion from_world = pose_math::inverse(frame).rotation;
  for (int i = 0; i < slots_of(what, 0); i += 3) {
    store(pose_math::rotate(from_world, load_vector(value + i)), value + i);
  }
}

namespace {

void scale(Dimension dimension, std::span<Slot> values) noexcept {
  for (Slot& value : values) value.real = from_si(value.real, dimension);
}

}  // namespace

void read_in_units(Reading what, std::span<const Dimension> axes, Slot* value) noexcept {
  switch (what) {
    case Reading::Clock:
    case Reading::Unix:
    case Reading::Now:
      return;
    case Reading::Joints:
      for (const Dimension axis : axes) scale(axis, {value++, 1});
      return;
    case Reading::Force:
      return scale(kForce, {value, 3});
    case Reading::Torque:
      return scale(kTorque, {value, 3});
    case Reading::Wrench:
      scale(kForce, {value, 3});
      return scale(kTorque, {value + 3, 3});
    default:
      return scale(kLength, {value, 3});
  }
}

}  // namespace rob::lang
