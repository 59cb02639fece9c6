#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "drivers/protocol/grbl_line.h"
#include "drivers/serial/wire_port.h"

namespace rob::drivers {

/// Lines and real-time bytes to grbl, and its lines back.
class GrblPort {
 public:
  /// Forgets what came before.
  void attach(WirePort& port) noexcept;

  bool send(std::string_view text) noexcept;
  bool send_byte(std::uint8_t byte) noexcept;
  /// The next line, by `deadline` at the latest. False: there is none, or the port has gone().
  bool next_line(grbl::Line& line, double deadline) noexcept;

  bool gone() const noexcept { return gone_; }
  const WirePort& port() const noexcept { return *port_; }
  const std::string& path() const noexcept { return port_->path(); }

 private:
  WirePort* port_ = nullptr;
  grbl::LineReader reader_;
  std::array<std::uint8_t, 512> bytes_{};
  Bytes unread_;
  bool gone_ = false;
};

}  // namespace rob::drivers
