#pragma once

#include <memory>
#include <string>

#include "motion/collision/collision_data.h"
#include "motion/collision/convex_body.h"
#include "motion/space/pose.h"
#include "runtime/meshes/hull.h"

namespace rob::runtime {

/// A convex hull in the world, as a thing to be hit.
std::shared_ptr<const motion::ConvexBody> convex_body(const Hull& hull);

/// The convex hull of the mesh in a file, whose lengths are in m, brought to `place`. Throws
/// motion::RobotFileError for a file that cannot be read, and for a mesh that is too large.
std::shared_ptr<const motion::ConvexBody> body_of_mesh(const std::string& file,
                                                       const motion::Pose& place);

/// Reads the meshes that a robot's file or a cell's names: they become obstacles. Throws
/// motion::RobotFileError, with the place in that file.
void read_meshes(motion::CollisionData& data);

}  // namespace rob::runtime
