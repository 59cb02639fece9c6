#pragma once

#include <vector>

#include "motion/dynamics/arm_mechanics.h"
#include "motion/robots/robot_model.h"
#include "motion/robots/table_reader.h"

namespace rob::motion {

/// The table [dynamics] of a robot file, S2's table of an arm, and with it the table [axis.motor]
/// of each axis. Throws RobotFileError for values that can be no arm's. `axes`: one reader an axis.
ArmMechanics read_mechanics(const TableReader& file, const std::vector<TableReader>& axes);

/// The table [simulation]; what it does not say is as the servo believes.
SimulatedDeviation read_deviation(const TableReader& file);

}  // namespace rob::motion
