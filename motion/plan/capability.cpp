#include "motion/plan/capability.h"

namespace rob::motion {

bool can(const RobotModel& robot, Capability capability) noexcept {
  switch (capability) {
    case Capability::AccelerationBound:
    case Capability::JerkBound:
    case Capability::Path:
      return robot.law == Law::LookAhead;
    case Capability::Force:
      return robot.force_sensor;
    case Capability::Lead:
      return robot.kinematics->inverts();
  }
  return false;
}

bool can(const RobotModel& robot, Law law) noexcept {
  return law == Law::LookAhead || robot.t_acc > 0;
}

}  // namespace rob::motion
