#pragma once

#include <Eigen/Geometry>

namespace rob::motion {

/// Two orientations whose shortest rotation is longer than this (rad) are half a turn apart: there
/// is no shortest one. [choice] 1e-10 rad off π, far above rounding.
inline constexpr double kLongestTurn = 3.14159265348979;

/// The rotation about `vector`'s direction by its length, rad.
Eigen::Quaterniond rotation_by(const Eigen::Vector3d& vector);

/// The other way round: of the shortest rotation that `turn` is; its length is 0 … π.
Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& turn);

/// The rotation vector that turns `from` into `to`, about axes of the world.
inline Eigen::Vector3d rotation_between(const Eigen::Quaterniond& from,
                                        const Eigen::Quaterniond& to) {
  return rotation_vector(to * from.conjugate());
}

}  // namespace rob::motion
