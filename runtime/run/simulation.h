#pragma once

#include <cstdint>
#include <memory>

#include "motion/robots/robot_model.h"
#include "motion/servo/servo_backend.h"

namespace rob::runtime {

/// The simulated machine that goes with a robot, powered down.
std::unique_ptr<motion::ServoBackend> simulation_of(const motion::RobotModel& robot);

/// Puts the robot into another cell of its kind, that of `seed`. The values for forces in the robot
/// file stay: they hold for all cells. Does nothing without a cell.
void change_cell(motion::RobotModel& robot, std::uint64_t seed);

}  // namespace rob::runtime
