#include "runtime/run/mesh_functions.h"

#include <unistd.h>

#include <filesystem>
#include <system_error>

#include "runtime/files/files.h"

namespace rob::runtime {

namespace {

MeshFunctions provided;
char** kept_arguments = nullptr;

}  // namespace

void provide(const MeshFunctions& functions) { provided = functions; }

const MeshFunctions& mesh_functions() {
  if (provided.body == nullptr) {
    go_on_with_geometry();
    throw FileError(kNoGeometry);
  }
  return provided;
}

void keep_arguments(char** arguments) { kept_arguments = arguments; }

void go_on_with_geometry() {
  if (provided.body != nullptr || kept_arguments == nullptr) return;
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::string other = (self.parent_path() / "rob-geometry").string();
  ::execv(other.c_str(), kept_arguments);
}

}  // namespace rob::runtime
