#pragma once

#include <cstdint>
#include <string>

#include "lang/text/diagnostic.h"
#include "lang/values/pose_math.h"
#include "lang/values/setting.h"

namespace rob::lang {

/// An OBSTACLE of a program: a thing that stands in the world. SI.
struct Obstacle {
  enum class Kind : std::uint8_t { Box, Sphere, Capsule, Mesh };

  std::string name;
  Place place{};  ///< of its shape
  Kind kind = Kind::Box;
  PoseValue pose{};      ///< of a box its centre, of a mesh its origin
  Vector3 size{};        ///< of a box
  CapsuleValue round{};  ///< a capsule, or a sphere at its `from`
  std::string file{};    ///< of a mesh, as the program names it
};

}  // namespace rob::lang
