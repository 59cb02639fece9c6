#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "motion/collision/convex_body.h"
#include "motion/collision/shapes.h"

namespace rob::motion {

/// A body has at most so many.
inline constexpr std::size_t kMostCapsules = 3;

/// A part of a robot that can hit something: its base, a link, its flange with what that carries.
struct Body {
  std::string name;
  int frame = 0;                ///< 0: the base; k: what axis k moves, from 1; axes + 1: the flange
  std::vector<Capsule> shapes;  ///< seen from that frame, m
};

/// A thing that stands in the world.
struct Obstacle {
  std::string name;
  std::variant<Sphere, Capsule, Box, HalfSpace, std::shared_ptr<const ConvexBody>> shape;
  bool hand_may_touch = false;  ///< the flange and what it carries work at it
  bool of_program = false;      ///< a program has declared it
};

/// An obstacle whose file has not been read yet: motion reads no meshes.
struct MeshObstacle {
  std::string name;
  std::string file;
  Pose place;
  std::string where;  ///< "file:line:column: " of what names it
};

/// Two bodies, or a body and an obstacle, that may always touch.
using Apart = std::pair<std::string, std::string>;

/// All of a robot that can hit something, and what there is to be hit. Without bodies nothing is
/// looked for.
struct CollisionData {
  std::vector<Body> bodies{};
  std::vector<Obstacle> obstacles{};
  std::vector<MeshObstacle> meshes{};  ///< that are to become obstacles
  std::vector<Apart> apart{};
  std::vector<std::string> allowed{};  ///< bodies and obstacles that may touch anything
  double clearance = 0.010;            ///< m: obstacles that are passed more closely are a warning
};

}  // namespace rob::motion
