#pragma once

#include <vector>

#include "motion/robots/robot_model.h"
#include "motion/robots/table_reader.h"

namespace rob::motion {

/// The table [chain] of a robot file, [axis.joint] of its axes, the first ones, as far as they have
/// it, and what of a pose its targets leave open. Needs the robot's axes. Throws RobotFileError
/// where none has a joint, and where one after the chain has.
void read_chain(const TableReader& file, const std::vector<TableReader>& axes, RobotModel& robot);

}  // namespace rob::motion
