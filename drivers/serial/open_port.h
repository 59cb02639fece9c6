#pragma once

#include <memory>
#include <string>

#include "drivers/serial/wire_port.h"

namespace rob::drivers {

/// Opens "tcp://host:port" or the path of a serial port. Throws motion::DriverError.
std::unique_ptr<WirePort> open_port(const std::string& path, int baud);

}  // namespace rob::drivers
