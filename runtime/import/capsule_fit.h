#pragma once

#include <vector>

#include "motion/collision/collision_data.h"
#include "runtime/import/body.h"

namespace rob::runtime {

/// One to three capsules in which all bodies of a link lie: of a rod that around its whole length,
/// of a ball itself, of a hull the smallest of those around its principal axes and the line of its
/// two farthest vertices, in up to three parts where it would have more than twice the volume. More
/// than three bodies count as one hull. None of no body.
std::vector<motion::Capsule> fitted_capsules(const std::vector<Body>& bodies);

/// m: how far the capsules stand out from the bodies at most.
double standing_out(const std::vector<motion::Capsule>& capsules, const std::vector<Body>& bodies);

}  // namespace rob::runtime
