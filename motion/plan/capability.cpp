#include "motion/plan/capability.h"

namespace rob::motion {

bool can(const RobotModel& robot, Capability capability) noexcept {
  if (capability == Capability::Rates) return true;
  return robot.law != Law::Paul;
}

}  // namespace rob::motion
