#pragma once

#include <string>
#include <vector>

#include "runtime/prompt/pendant.h"

namespace rob::runtime {

/// The keys that do something now, on this robot: "[ ] speed", each by itself.
std::vector<std::string> acting_keys(const Pendant& pendant);

}  // namespace rob::runtime
