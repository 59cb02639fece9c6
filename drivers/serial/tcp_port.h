#pragma once

#include <string>

#include "drivers/serial/wire_port.h"

namespace rob::drivers {

/// Whether a port's name means a network connection: "tcp://host:port".
bool is_network_address(const std::string& path);

/// A machine's serial line that a network carries: grblHAL's telnet port, or a serial server in
/// front of a bus. Small packets leave at once (TCP_NODELAY). A connection that breaks is Gone and
/// is not made again.
class TcpPort final : public WirePort {
 public:
  /// `address`: "tcp://host:port", "tcp://[::1]:port". Waits 3 s at most for the other side; throws
  /// motion::DriverError for an address that is none, a host that is not known, and a connection
  /// that is refused or not answered.
  explicit TcpPort(const std::string& address);

 private:
  std::ptrdiff_t put(std::span<const std::uint8_t> bytes) noexcept override;
};

}  // namespace rob::drivers
