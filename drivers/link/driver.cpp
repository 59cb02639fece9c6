#include "drivers/link/driver.h"

#include <algorithm>
#include <array>

#include "drivers/link/grbl_driver.h"
#include "drivers/link/rob_driver.h"
#include "drivers/link/servo_driver.h"

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

}  // namespace rob::drivers
