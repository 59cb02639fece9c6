#pragma once

#include <memory>

#include "motion/kinematics/arm_kinematics.h"
#include "motion/robots/table_reader.h"

namespace rob::motion {

/// The table [arm] of a robot file: the seven measures, and how the axes count. Throws
/// RobotFileError for measures that are no arm's.
std::shared_ptr<const ArmKinematics> read_arm(const TableReader& file);

}  // namespace rob::motion
