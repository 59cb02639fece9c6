#pragma once

#include <string>

#include "drivers/serial/wire_port.h"

namespace rob::drivers {

/// A serial port of this computer: raw, 8 data bits, no parity, one stop bit, no flow control. Only
/// this process can use it: TIOCEXCL keeps others out, flock() keeps out root too and names the
/// process that holds it.
class SerialPort final : public WirePort {
 public:
  /// Throws motion::DriverError that says what to do: there is no such port (lists the ports), it
  /// is not permitted (see permission_advice()), another process uses it (names it), it is no
  /// serial port, or it does not have this speed.
  SerialPort(const std::string& path, int baud);
  ~SerialPort() override;

  /// A USB adapter collects bytes for that long, ms; 0 where the port does not say. More than 1
  /// breaks a cycle of 10 ms.
  int latency_timer() const noexcept { return latency_timer_; }

 private:
  void configure(int baud);

  int latency_timer_ = 0;
};

}  // namespace rob::drivers
