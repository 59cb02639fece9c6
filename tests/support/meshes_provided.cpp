// Tests that read meshes have the libraries for them from the start.
#include "runtime/meshes/mesh_obstacle.h"
#include "runtime/run/mesh_functions.h"

namespace {

[[maybe_unused]] const bool kProvided = [] {
  rob::runtime::provide({rob::runtime::body_of_mesh, rob::runtime::read_meshes});
  return true;
}();

}  // namespace
