#include "lang/machine/seen_from.h"

#include "lang/values/pose_slots.h"

namespace rob::lang {

void turn_into_frame(Reading what, const Setting& setting, const PoseValue& tool, Slot* value) {
  if (!needs_sensor(what)) return;
  const PoseValue& frame = setting.in_tool ? tool : setting.frame;
  const Quaternion from_world = pose_math::inverse(frame).rotation;
  for (int i = 0; i < slots_of(what, 0); i += 3) {
    store(pose_math::rotate(from_world, load_vector(value + i)), value + i);
  }
}

}  // namespace rob::lang
