#pragma once

#include <vector>

#include "motion/collision/collision_data.h"
#include "motion/space/joint_vector.h"
#include "runtime/import/imported_arm.h"

namespace rob::runtime {

/// The pairs of links, neighbours aside, that are closer than 1 mm in each of 10,000 postures, the
/// points of a Halton sequence within the limits. `links`: base, axes of the chain, flange.
std::vector<motion::Apart> always_touching(const ImportedArm& arm,
                                           const std::vector<motion::Body>& links);

}  // namespace rob::runtime
