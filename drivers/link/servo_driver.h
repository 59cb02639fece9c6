#pragma once

#include <memory>
#include <span>
#include <vector>

#include "drivers/link/wire_backend.h"
#include "drivers/link/wire_link.h"
#include "drivers/link/wired_axis.h"

namespace rob::drivers {

// Servos on a bus: a ServoLink in the dialect of each maker, and its machine (Driver::make).

std::unique_ptr<WireLink> dynamixel_link(const std::vector<WireAxis>& axes, int baud);
std::unique_ptr<WireLink> feetech_link(const std::vector<WireAxis>& axes, int baud);
std::unique_ptr<WireLink> feetech_scs_link(const std::vector<WireAxis>& axes, int baud);

std::unique_ptr<WireBackend> make_dynamixel(WireSettings settings, std::span<const WiredAxis> axes);
std::unique_ptr<WireBackend> make_feetech(WireSettings settings, std::span<const WiredAxis> axes);
std::unique_ptr<WireBackend> make_feetech_scs(WireSettings settings,
                                              std::span<const WiredAxis> axes);

}  // namespace rob::drivers
