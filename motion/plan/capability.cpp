#include "motion/plan/capability.h"

namespace rob::motion {

namespace {

/// For a robot whose coordinates are its axes.
bool turns_about_z(const RobotModel& robot) noexcept {
  constexpr int kC = 5;  // of x, y, z, a, b, c
  for (int i = 0; i < robot.axis_count(); ++i)
    if (robot.kinematics->coordinate(i) == kC) return true;
  return false;
}

}  // namespace

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
    case Capability::TurnAboutZ:
      return robot.tool_coordinates || turns_about_z(robot);
  }
  return false;
}

bool can(const RobotModel& robot, Law law) noexcept {
  return law == Law::LookAhead || robot.t_acc > 0;
}

}  // namespace rob::motion
