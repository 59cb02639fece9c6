#pragma once

#include <memory>
#include <span>

#include "drivers/link/wire_backend.h"
#include "drivers/link/wired_axis.h"

namespace rob::drivers {

/// A machine with grbl (Driver::make).
std::unique_ptr<WireBackend> make_grbl(WireSettings settings, std::span<const WiredAxis> axes);

}  // namespace rob::drivers
