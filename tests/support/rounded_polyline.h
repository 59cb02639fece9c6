#pragma once

#include <Eigen/Core>
#include <vector>

#include "tests/support/topp.h"

namespace rob::test {

/// A polyline whose corners are parabolas that miss their points by `zone`, or by as much less as
/// half of the shorter leg demands; as time_optimal() takes it. Its time is that of a good
/// rounding: legs shared half and half, no merging of short ones. mm.
std::vector<ToppNode> rounded_polyline(const std::vector<Eigen::Vector3d>& places, double zone);

}  // namespace rob::test
