#include "runtime/cli/import_files.h"
#include "runtime/cli/run_rob.h"
#include "runtime/meshes/mesh_obstacle.h"
#include "runtime/run/mesh_functions.h"

/// `rob-geometry`: see runtime/run/mesh_functions.h.
int main(int argc, char** argv) {
  using namespace rob::runtime;
  provide({body_of_mesh, read_meshes});
  return run_rob(argc, argv, import_files);
}
