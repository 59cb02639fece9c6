#pragma once

#include <memory>
#include <vector>

#include "motion/kinematics/chain_kinematics.h"
#include "motion/robots/table_reader.h"

namespace rob::motion {

/// The table [chain] of a robot file, and [axis.joint] of its axes: the first ones, as far as they
/// have it. Throws RobotFileError where none has, and where one after the chain has.
std::shared_ptr<const ChainKinematics> read_chain(const TableReader& file,
                                                  const std::vector<TableReader>& axes);

}  // namespace rob::motion
