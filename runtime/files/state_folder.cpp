#include "runtime/files/state_folder.h"

#include <cstdlib>

namespace rob::runtime {

std::filesystem::path state_folder() {
  const char* const state = std::getenv("XDG_STATE_HOME");
  if (state != nullptr && *state == '/') return std::filesystem::path(state) / "rob";
  const char* const home = std::getenv("HOME");
  if (home == nullptr || *home != '/') return {};
  return std::filesystem::path(home) / ".local" / "state" / "rob";
}

}  // namespace rob::runtime
