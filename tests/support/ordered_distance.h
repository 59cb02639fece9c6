#pragma once

#include <Eigen/Core>
#include <vector>

namespace rob::test {

/// How far a curve is from a path of straight pieces when both are gone along together, neither of
/// them backwards: the Fréchet distance (Alt and Godau 1995), mm, within a hundredth of it or
/// 1e-6 mm. So far is the curve from the path at most, and so far from each of its corners, in
/// their order, however the path crosses itself or lies beside itself. Infinite where it is above
/// `most`. The curve is taken at its places alone: they have to lie close to each other.
double ordered_distance(const std::vector<Eigen::Vector3d>& curve,
                        const std::vector<Eigen::Vector3d>& path, double most);

}  // namespace rob::test
