#include "runtime/meshes/mesh_file.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "lang/text/visible.h"
#include "motion/robots/robot_file_error.h"

namespace rob::runtime {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostMesh = std::uintmax_t{256} << 20U;  // bytes [choice]
constexpr std::size_t kMostVertices = 5'000'000;                  // [choice]

[[noreturn]] void refuse_mesh(const std::string& file, const std::string& problem) {
  throw motion::RobotFileError(lang::visible(file) + ": " + lang::visible(problem));
}

bool is_there(const fs::path& path) {
  std::error_code none;
  return fs::is_regular_file(path, none);
}

/// NAME/rest within `folder`, where the folder itself may be the package.
std::string in_package(const fs::path& folder, const fs::path& name, const fs::path& rest) {
  if (is_there(folder / name / rest)) return (folder / name / rest).string();
  if (folder.filename() == name && is_there(folder / rest)) return (folder / rest).string();
  return "";
}

std::string found_above(const std::string& urdf, const fs::path& name, const fs::path& rest) {
  std::error_code none;
  for (fs::path at = fs::absolute(urdf, none).lexically_normal().parent_path();;
       at = at.parent_path()) {
    const std::string found = in_package(at, name, rest);
    if (!found.empty() || at == at.parent_path()) return found;
  }
}

std::string find_in_packages(std::string_view inside, const std::string& urdf,
                             const std::string& packages) {
  const std::size_t slash = std::min(inside.find('/'), inside.size());
  const fs::path name(inside.substr(0, slash));
  const fs::path rest(inside.substr(std::min(slash + 1, inside.size())));
  if (!packages.empty()) {
    std::string found = in_package(packages, name, rest);
    if (found.empty() && is_there(fs::path(packages) / rest))
      found = (fs::path(packages) / rest).string();
    if (!found.empty()) return found;
  }
  return found_above(urdf, name, rest);
}

void check_mesh(const std::string& file) {
  const std::string ending = fs::path(file).extension().string();
  std::string small;
  for (const char c : ending) small += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  if (small != ".stl" && small != ".dae" && small != ".obj")
    refuse_mesh(file, "a mesh is an .stl, .dae or .obj file");
  std::error_code error;
  if (fs::file_size(file, error) > kMostMesh || error)
    refuse_mesh(file, fmt::format("cannot be read, or has more than {} MiB", kMostMesh >> 20U));
}

void add_vertices(const aiScene& scene, const aiNode& node, const aiMatrix4x4& above,
                  std::vector<Eigen::Vector3d>& vertices) {
  const aiMatrix4x4 placed = above * node.mTransformation;
  for (unsigned i = 0; i < node.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[i]];
    for (unsigned v = 0; v < mesh.mNumVertices && vertices.size() <= kMostVertices; ++v) {
      const aiVector3D at = placed * mesh.mVertices[v];
      vertices.emplace_back(at.x, at.y, at.z);
    }
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i)
    add_vertices(scene, *node.mChildren[i], placed, vertices);
}

}  // namespace

std::string find_mesh(const std::string& written, const std::string& urdf,
                      const std::string& packages) {
  constexpr std::array<std::string_view, 2> kPackages{"package://", "model://"};
  constexpr std::string_view kFile = "file://";
  std::string found;
  for (const std::string_view scheme : kPackages)
    if (written.starts_with(scheme))
      found = find_in_packages(std::string_view(written).substr(scheme.size()), urdf, packages);
  if (written.find("://") == std::string::npos) {
    found = (fs::path(urdf).parent_path() / written).string();
  } else if (written.starts_with(kFile)) {
    found = written.substr(kFile.size());
  }
  if (!found.empty() && is_there(found)) return found;
  refuse_mesh(urdf,
              fmt::format("there is no mesh {}; --package DIR says where its package is, and a "
                          "link without <collision> needs none but is not checked",
                          written));
}

std::vector<Eigen::Vector3d> mesh_vertices(const std::string& file) {
  check_mesh(file);
  Assimp::Importer importer;
  // Links count with z up, as their joints do, whatever the mesh says of itself.
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* const scene = importer.ReadFile(file, aiProcess_JoinIdenticalVertices);
  if (scene == nullptr || scene->mRootNode == nullptr)
    refuse_mesh(file, fmt::format("is no mesh that can be read: {}", importer.GetErrorString()));
  std::vector<Eigen::Vector3d> vertices;
  add_vertices(*scene, *scene->mRootNode, aiMatrix4x4(), vertices);
  if (vertices.empty()) refuse_mesh(file, "the mesh has no vertices");
  if (vertices.size() > kMostVertices)
    refuse_mesh(file, fmt::format("the mesh has more than {} vertices", kMostVertices));
  return vertices;
}

}  // namespace rob::runtime
