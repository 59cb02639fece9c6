#pragma once

#include <memory>
#include <vector>

#include "motion/kinematics/arm_kinematics.h"
#include "motion/robots/robot_model.h"
#include "motion/robots/table_reader.h"

namespace rob::motion {

/// The table [arm] of a robot file: the seven measures, and how the axes count. `axes`: with their
/// limits. Throws RobotFileError for measures that are no arm's.
std::shared_ptr<const ArmKinematics> read_arm(const TableReader& file,
                                              const std::vector<Axis>& axes);

}  // namespace rob::motion
