#pragma once

#include <cstdint>
#include <unordered_set>

#include "motion/collision/clearance.h"
#include "motion/plan/segment_descriptor.h"

namespace rob::runtime {

/// Motions that were foretold from end to end and hit nothing, each by its mark.
using ClearedWays = std::unordered_set<std::uint64_t>;

/// A number by which a motion is known again: two of the same number are the same way, out of the
/// same corner, at the same speed. `before`: the number of the motion that it comes out of a corner
/// of; 0: it begins at rest.
std::uint64_t way_mark(std::uint64_t before, const motion::JointVector& from,
                       const motion::SegmentMotion& motion);

/// The same of what motions must not hit: other bodies, obstacles or permissions, another number.
std::uint64_t mark_of(const motion::Clearance& clearance);

}  // namespace rob::runtime
