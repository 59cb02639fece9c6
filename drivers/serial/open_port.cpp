#include "drivers/serial/open_port.h"

#include "drivers/serial/serial_port.h"
#include "drivers/serial/tcp_port.h"

namespace rob::drivers {

std::unique_ptr<WirePort> open_port(const std::string& path, int baud) {
  if (is_network_address(path)) return std::make_unique<TcpPort>(path);
  return std::make_unique<SerialPort>(path, baud);
}

}  // namespace rob::drivers
