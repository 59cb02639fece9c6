#include "runtime/run/program_obstacles.h"

#include <filesystem>

#include "motion/robots/robot_file_error.h"
#include "runtime/run/mesh_functions.h"
#include "runtime/words/codes.h"
#include "runtime/words/pose_values.h"

namespace rob::runtime {

namespace {

motion::Obstacle obstacle_of(const lang::Obstacle& declared, const std::string& folder) {
  motion::Obstacle obstacle{.name = declared.name, .shape = motion::Sphere{}, .of_program = true};
  const lang::CapsuleValue& round = declared.round;
  switch (declared.kind) {
    case lang::Obstacle::Kind::Box:
      obstacle.shape = motion::Box{to_motion(declared.pose), eigen_of(declared.size) / 2};
      break;
    case lang::Obstacle::Kind::Sphere:
      obstacle.shape = motion::Sphere{eigen_of(round.from), round.radius};
      break;
    case lang::Obstacle::Kind::Capsule:
      obstacle.shape = motion::Capsule{eigen_of(round.from), eigen_of(round.to), round.radius};
      break;
    case lang::Obstacle::Kind::Mesh:
      obstacle.shape = mesh_functions().body(
          (std::filesystem::path(folder) / declared.file).string(), to_motion(declared.pose));
      break;
  }
  return obstacle;
}

}  // namespace

std::vector<motion::Obstacle> obstacles_of(lang::Compilation& compilation,
                                           const std::string& folder) {
  std::vector<motion::Obstacle> obstacles;
  if (!compilation.chunk) return obstacles;
  for (const lang::Obstacle& declared : compilation.chunk->obstacles) {
    try {
      obstacles.push_back(obstacle_of(declared, folder));
    } catch (const motion::RobotFileError& error) {
      compilation.diagnostics.error(code::kMeshUnreadable, declared.place, error.what(),
                                    "MESH names an .stl, .dae or .obj file beside the program");
    }
  }
  if (obstacles.size() < compilation.chunk->obstacles.size()) compilation.chunk.reset();
  return obstacles;
}

}  // namespace rob::runtime
