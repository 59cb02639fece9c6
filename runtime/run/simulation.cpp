#include "runtime/run/simulation.h"

#include <vector>

#include "drivers/contact/drawn_cell.h"
#include "drivers/contact/sim_cell.h"
#include "drivers/sim/sim_arm.h"
#include "drivers/sim/sim_gantry.h"
#include "motion/kinematics/arm_kinematics.h"
#include "motion/servo/pulse_servo.h"
#include "runtime/tick/axis_values.h"

namespace rob::runtime {

namespace {

/// The mechanics of the arm as the simulation has it.
motion::ArmMechanics real_mechanics(const motion::RobotModel& robot) {
  const auto& arm = dynamic_cast<const motion::ArmKinematics&>(*robot.kinematics).parameters();
  motion::ArmMechanics mechanics = *robot.mechanics;
  mechanics.dynamics = motion::Ums7Dynamics(
      motion::with_payload(motion::scaled(mechanics.dynamics.parameters(), robot.deviation.masses),
                           robot.deviation.payload, arm.c2, arm.c3, arm.c4));
  return mechanics;
}

/// Empty where the drives take forces.
std::vector<drivers::PulseDrive> pulse_drives_of(const motion::RobotModel& robot) {
  std::vector<drivers::PulseDrive> pulse_drives;
  if (robot.servo == motion::ServoStructure::Force) return pulse_drives;
  for (const motion::Axis& axis : robot.axes) {
    const bool counts = robot.servo == motion::ServoStructure::PulseTrain;
    const double kp =
        motion::pulse_gains(axis.drive, axis.pulses, robot.servo, robot.servo_period).kp;
    pulse_drives.emplace_back(axis.pulses, robot.servo_period, counts ? kp : 0);
  }
  return pulse_drives;
}

std::unique_ptr<drivers::SimMachine> machine_of(const motion::RobotModel& robot) {
  const std::vector<motion::DriveData> drives = drives_of(robot);
  std::vector<drivers::SimActuatorParameters> actuators;
  for (const motion::TwoPositionActuator& a : robot.actuators) {
    actuators.push_back({a.output, a.input_off, a.input_on, a.travel_time});
  }
  if (robot.mechanics) {
    return std::make_unique<drivers::SimArm>(
        drivers::SimArmParameters{drives, real_mechanics(robot), robot.start, actuators,
                                  robot.deviation.friction, !robot.deviation.fixed});
  }
  return std::make_unique<drivers::SimGantry>(
      drivers::SimGantryParameters{drives, robot.start, actuators, pulse_drives_of(robot)});
}

}  // namespace

std::unique_ptr<motion::ServoBackend> simulation_of(const motion::RobotModel& robot) {
  std::unique_ptr<drivers::SimMachine> machine = machine_of(robot);
  if (!robot.cell) return machine;
  return std::make_unique<drivers::SimCell>(std::move(machine), robot.kinematics, *robot.cell,
                                            robot.cell->sensor.delay);
}

void change_cell(motion::RobotModel& robot, std::uint64_t seed) {
  if (robot.cell) robot.cell = drivers::drawn_cell(*robot.cell, seed);
}

}  // namespace rob::runtime
