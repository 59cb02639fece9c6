#pragma once

#include <string_view>

#include "motion/robots/robot_model.h"
#include "motion/robots/table_reader.h"

namespace rob::motion {

/// The channel of the robot's signal that `key` of a table names.
int signal_channel(const TableReader& table, std::string_view key, bool output,
                   const RobotModel& robot);

}  // namespace rob::motion
