#pragma once

#include <memory>

#include "motion/robots/robot_model.h"
#include "motion/servo/servo_backend.h"

namespace rob::runtime {

/// The simulated machine that goes with a robot, powered down.
std::unique_ptr<motion::ServoBackend> simulation_of(const motion::RobotModel& robot);

}  // namespace rob::runtime
