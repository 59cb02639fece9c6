#pragma once

#include <memory>
#include <span>

#include "drivers/link/wire_backend.h"
#include "drivers/link/wired_axis.h"

namespace rob::drivers {

/// A device that speaks Rob's own protocol (Driver::make).
std::unique_ptr<WireBackend> make_rob(WireSettings settings, std::span<const WiredAxis> axes);

}  // namespace rob::drivers
