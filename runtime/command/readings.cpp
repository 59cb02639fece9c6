#include "runtime/command/readings.h"

#include "lang/values/pose_slots.h"
#include "motion/space/cycle_instant.h"
#include "runtime/command/axis_targets.h"
#include "runtime/words/force_words.h"
#include "runtime/words/pose_values.h"

namespace rob::runtime {

using lang::Reading;
using lang::Reply;

Reply Readings::read(Reading what, const lang::Setting& setting, lang::Slot* value) {
  if (is_observation(what) && !progress_.place_can_be_read()) return Reply::Later;
  if (what == Reading::Target && !queue_.rested()) return Reply::Later;
  return current(what, setting, value, links_.refuse);
}

Reply Readings::current(Reading what, const lang::Setting& setting, lang::Slot* value,
                        const Refuse& refuse) const {
  if (needs_sensor(what)) return felt(what, value, refuse);
  const motion::JointVector q = is_observation(what)       ? links_.channels.joints.load()
                                : what == Reading::HitPose ? guard_.hit()
                                                           : links_.planner.commanded();
  switch (what) {
    case Reading::Clock: {
      const std::int64_t cycle = links_.channels.cycle.load(std::memory_order_relaxed);
      value->real = motion::cycle_instant(cycle, links_.robot.reference_period);
      return Reply::Done;
    }
    case Reading::Now:
      value[1].real = links_.channels.begun.offset;
      [[fallthrough]];
    case Reading::Unix: {
      const std::int64_t cycle = links_.channels.cycle.load(std::memory_order_relaxed);
      value->real =
          links_.channels.begun.unix + motion::cycle_instant(cycle, links_.robot.reference_period);
      return Reply::Done;
    }
    case Reading::Joints:
      for (const double axis : q) (value++)->real = axis + 0.0;
      return Reply::Done;
    default:
      break;
  }
  lang::store(tool_at(links_.robot, q, setting), value);
  return Reply::Done;
}

/// A sensor gives its first value with the first servo cycle.
Reply Readings::felt(Reading what, lang::Slot* value, const Refuse& refuse) const {
  constexpr std::int64_t kFirstCycles = 3;
  const motion::JointVector wrench = links_.channels.wrench.load();
  if (wrench.size() > 0) {
    store_wrench(what, wrench.head<3>(), wrench.tail<3>(), value);
    return Reply::Done;
  }
  if (links_.channels.cycle.load(std::memory_order_relaxed) < kFirstCycles) return Reply::Later;
  return refuse(words_for_no_sensor(links_.robot));
}

lang::PoseValue Readings::forward(const lang::Setting& setting,
                                  std::span<const double> joints) const {
  return tool_at(links_.robot, joints_of(joints), setting);
}

Reply Readings::inverse(const lang::Setting& setting, const lang::PoseValue& pose,
                        std::span<const double> near, std::span<double> joints,
                        const Refuse& refuse) {
  if (near.empty() && !queue_.rested()) return Reply::Later;
  const motion::JointVector from = near.empty() ? links_.planner.commanded() : joints_of(near);
  if (auto words = axes_for(links_.robot, pose, setting, from, joints))
    return refuse(std::move(*words));
  return Reply::Done;
}

}  // namespace rob::runtime
