#include "drivers/link/wire_link.h"

#include <limits>

namespace rob::drivers {

WireLimits::WireLimits() {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  min.fill(-kNone);
  max.fill(kNone);
  speed.fill(kNone);
  acceleration.fill(kNone);
}

void WireLink::home(const std::function<bool()>&) {
  throw motion::DriverError(
      "this machine has no homing of its own: its encoders know where the axes stand");
}

}  // namespace rob::drivers
