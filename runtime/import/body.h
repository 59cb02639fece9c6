#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "runtime/meshes/hull.h"

/// The parts of a link, in the frame of its body. m.
namespace rob::runtime {

struct Ball {
  Eigen::Vector3d centre;
  double radius = 0;
};

struct Rod {  ///< a cylinder, flat at its ends
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  double radius = 0;
};

using Body = std::variant<Ball, Rod, Hull>;

}  // namespace rob::runtime
