#pragma once

#include <string>
#include <vector>

#include "runtime/import/body.h"
#include "runtime/import/imported_arm.h"

namespace rob::runtime {

/// The shapes of a link as bodies, meshes read and made convex. `urdf`, `packages`: as of
/// find_mesh(). Throws motion::RobotFileError for a shape that cannot be, and for a mesh that
/// cannot be read.
std::vector<Body> bodies_of(const RigidBody& link, const std::string& urdf,
                            const std::string& packages);

}  // namespace rob::runtime
