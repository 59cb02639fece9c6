#include "runtime/program/simulation.h"

#include <vector>

#include "drivers/sim_arm.h"
#include "drivers/sim_gantry.h"

namespace rob::runtime {

std::unique_ptr<motion::ServoBackend> simulation_of(const motion::RobotModel& robot) {
  std::vector<motion::DriveData> drives;
  for (const motion::Axis& axis : robot.axes) drives.push_back(axis.drive);
  std::vector<drivers::SimActuatorParameters> actuators;
  for (const motion::TwoPositionActuator& a : robot.actuators) {
    actuators.push_back({a.output, a.input_off, a.input_on, a.travel_time});
  }
  if (robot.mechanics) {
    return std::make_unique<drivers::SimArm>(
        drivers::SimArmParameters{drives, *robot.mechanics, robot.start, actuators, 1});
  }
  return std::make_unique<drivers::SimGantry>(
      drivers::SimGantryParameters{drives, robot.start, actuators});
}

}  // namespace rob::runtime
