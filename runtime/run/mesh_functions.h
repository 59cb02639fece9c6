#pragma once

#include <memory>
#include <string>

#include "motion/collision/collision_data.h"
#include "motion/space/pose.h"

/// Meshes need large libraries, and to load these takes longer than a short run. Therefore `rob`
/// has none of them. `rob-geometry` beside it is the same program with them: where a mesh or a URDF
/// is to be read, it goes on in place of `rob`.
namespace rob::runtime {

/// As of runtime/meshes/mesh_obstacle.h.
struct MeshFunctions {
  std::shared_ptr<const motion::ConvexBody> (*body)(const std::string& file,
                                                    const motion::Pose& place) = nullptr;
  void (*read)(motion::CollisionData& data) = nullptr;
};

/// At the start, in the only thread: this program has them.
void provide(const MeshFunctions& functions);
/// Where this program has none, rob-geometry goes on in its place. Throws FileError if it is not
/// there.
const MeshFunctions& mesh_functions();

/// At the start: the arguments of main().
void keep_arguments(char** arguments);
/// rob-geometry goes on with the same arguments, as though this program had not begun: nothing may
/// be open, printed or under way. Returns where there is no such program, or this is it.
void go_on_with_geometry();
/// What to say then.
inline constexpr const char* kNoGeometry =
    "meshes and URDFs are read by rob-geometry, which is not beside rob; build or install it, too";

}  // namespace rob::runtime
