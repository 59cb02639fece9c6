#include "motion/plan/capability.h"

namespace rob::motion {

bool can(const RobotModel& robot, Capability /*capability*/) noexcept {
  return robot.law != Law::Paul;
}

}  // namespace rob::motion
