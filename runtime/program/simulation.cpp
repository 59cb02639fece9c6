#include "runtime/program/simulation.h"

#include "drivers/sim_gantry.h"

namespace rob::runtime {

std::unique_ptr<motion::ServoBackend> simulation_of(const motion::RobotModel& robot) {
  drivers::SimGantryParameters parameters;
  parameters.start = robot.start;
  for (const motion::Axis& axis : robot.axes) parameters.drives.push_back(axis.drive);
  for (const motion::TwoPositionActuator& a : robot.actuators) {
    parameters.actuators.push_back({a.output, a.input_off, a.input_on, a.travel_time});
  }
  return std::make_unique<drivers::SimGantry>(parameters);
}

}  // namespace rob::runtime
