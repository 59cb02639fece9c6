#pragma once

#include "motion/robots/robot_model.h"
#include "motion/robots/table_reader.h"

namespace rob::motion {

/// Reads [force] of a robot file: what is known of its force sensor.
void read_force(const TableReader& file, RobotModel& robot);

/// Reads [cell]: the surroundings of the simulated robot's tool, where the file has them. Needs the
/// robot's signals, and [force].
void read_cell(const TableReader& file, RobotModel& robot);

}  // namespace rob::motion
