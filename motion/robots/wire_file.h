#pragma once

#include <vector>

#include "motion/robots/robot_model.h"
#include "motion/robots/table_reader.h"

namespace rob::motion {

/// Reads [wire] of a robot file and [axis.wire] of its axes (docs/drivers.md), where they are.
void read_wire(const TableReader& file, const std::vector<TableReader>& axes, RobotModel& robot);

}  // namespace rob::motion
