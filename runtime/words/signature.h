#pragma once

#include "lang/machine/robot_signature.h"
#include "motion/robots/robot_model.h"

namespace rob::runtime {

/// The robot as the language knows it: axes, coordinates and signals by name, channels from 1.
/// Channels that the robot file does not name have an empty name.
lang::RobotSignature signature_of(const motion::RobotModel& robot);

}  // namespace rob::runtime
