#include "drivers/link/driver.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "drivers/link/grbl_link.h"
#include "drivers/link/rob_link.h"
#include "drivers/link/servo_link.h"

namespace rob::drivers {

namespace {

constexpr std::array kDrivers{
    Driver{"grbl", "a machine with grbl 1.1 or grblHAL", 115200, false, make_grbl},
    Driver{"dynamixel", "servos of ROBOTIS' X series, protocol 2.0", 1000000, true, make_dynamixel},
    Driver{"feetech", "servos of Feetech's STS series", 1000000, true, make_feetech},
    Driver{"feetech-scs", "servos of Feetech's SCS series", 1000000, true, make_feetech_scs},
    Driver{"rob", "a device with Rob's own protocol", 115200, true, make_rob}};

}  // namespace

std::span<const Driver> drivers() { return kDrivers; }

const Driver* find_driver(std::string_view name) {
  const auto found =
      std::ranges::find_if(kDrivers, [&](const Driver& driver) { return driver.name == name; });
  return found == kDrivers.end() ? nullptr : &*found;
}

WireAxis axis_on(const WiredAxis& axis, double units, double travel, double zero) {
  WireAxis wire;
  wire.name = axis.name;
  wire.scale = axis.direction * units / travel;
  wire.offset = axis.offset - zero / wire.scale;
  wire.most_step = axis.v_max * std::abs(wire.scale);
  return wire;
}

void refuse_same_address(const std::vector<WireAxis>& axes, const std::string& what) {
  for (std::size_t i = 0; i < axes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (axes[i].address == axes[k].address)
        throw motion::DriverError("axes " + axes[k].name + " and " + axes[i].name +
                                  " have the same " + what +
                                  " on the wire; write [axis.wire] in the robot file");
}

}  // namespace rob::drivers
