#pragma once

#include <vector>

#include "motion/robots/robot_model.h"
#include "motion/robots/table_reader.h"

namespace rob::motion {

/// Reads which servo closes the loop, and, where it sends pulses, [axis.pulse_drive] of each axis
/// (docs/adding-a-robot.md). `axes`: the tables [[axis]] of robot.axes. Throws RobotFileError.
void read_servo(const TableReader& file, const std::vector<TableReader>& axes, RobotModel& robot);

}  // namespace rob::motion
