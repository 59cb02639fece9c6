#pragma once

#include <Eigen/Core>

namespace rob::motion {

/// The effect of the world on the tool: force and torque, N and Nm, along the axes of some frame.
/// Lives wholly in the object, so it may be used in the tick.
struct Wrench {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
};

}  // namespace rob::motion
