#pragma once

#include <string_view>
#include <vector>

#include "motion/robots/robot_model.h"
#include "motion/robots/table_reader.h"

namespace rob::motion {

/// The bodies of the robot, and what they can hit: [[base.shape]], [[axis.shape]],
/// [[flange.shape]],
/// [[obstacle]], [[apart]], `clearance`, and the table and racks of a simulated cell. After the
/// axes and the cell have been read. Throws RobotFileError.
void read_shapes(const TableReader& file, const std::vector<TableReader>& axes, RobotModel& robot);

/// The [[obstacle]]s of a cell's file, which stand beside those of the robot's file. `file_name` is
/// for messages. Throws RobotFileError.
void read_cell(std::string_view text, std::string_view file_name, CollisionData& data);

}  // namespace rob::motion
