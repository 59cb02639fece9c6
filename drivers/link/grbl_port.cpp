#include "drivers/link/grbl_port.h"

namespace rob::drivers {

namespace {

constexpr double kSendTime = 0.5;  // s [choice] for the port to take a line

}  // namespace

void GrblPort::attach(WirePort& port) noexcept {
  port_ = &port;
  reader_.clear();
  unread_ = {};
  gone_ = false;
}

bool GrblPort::send(std::string_view text) noexcept {
  const auto* first = reinterpret_cast<const std::uint8_t*>(text.data());
  const WireIo io = port_->write({first, text.size()}, wire_time() + kSendTime);
  gone_ = gone_ || io.status == WireIo::Status::Gone;
  return io.status == WireIo::Status::Ok;
}

bool GrblPort::send_byte(std::uint8_t byte) noexcept {
  const char text = static_cast<char>(byte);
  return send({&text, 1});
}

bool GrblPort::next_line(grbl::Line& line, double deadline) noexcept {
  for (;;) {
    std::string_view text;
    while (reader_.next(unread_, text))
      if (grbl::parse(text, line)) return true;
    const WireIo io = port_->read(bytes_, deadline);
    gone_ = gone_ || io.status == WireIo::Status::Gone;
    if (io.status != WireIo::Status::Ok) return false;
    unread_ = {bytes_.data(), io.bytes};
  }
}

}  // namespace rob::drivers
