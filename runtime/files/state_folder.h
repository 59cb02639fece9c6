#pragma once

#include <filesystem>

namespace rob::runtime {

/// The user's folder for what Rob keeps from one start to the next: $XDG_STATE_HOME/rob, else
/// ~/.local/state/rob. Empty where the user has none. It need not exist yet.
std::filesystem::path state_folder();

}  // namespace rob::runtime
