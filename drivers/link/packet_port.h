#pragma once

#include <array>

#include "drivers/protocol/frame_reader.h"
#include "drivers/serial/serial_port.h"

namespace rob::drivers {

/// Packets of one format on a port.
template <typename Format>
class PacketPort {
 public:
  using Frame = typename Format::Frame;
  enum class Result : std::uint8_t { Ok, TimedOut, Gone };

  void attach(SerialPort& port) {
    port_ = &port;
    reader_.clear();
  }
  const SerialPort& port() const noexcept { return *port_; }

  Result send(Bytes bytes, double deadline) noexcept {
    return result(port_->write(bytes, deadline).status);
  }
  /// The same, when what has come before is forgotten: nothing late is taken for the answer.
  Result ask(Bytes bytes, double deadline) noexcept {
    port_->discard_input();
    reader_.clear();
    return send(bytes, deadline);
  }
  /// The next whole packet.
  Result receive(Frame& frame, double deadline) noexcept {
    std::array<std::uint8_t, 256> bytes;
    while (!reader_.next(frame)) {
      const WireIo io = port_->read(bytes, deadline);
      if (io.status != WireIo::Status::Ok) return result(io.status);
      reader_.add({bytes.data(), io.bytes});
    }
    return Result::Ok;
  }
  std::uint32_t broken() const noexcept { return reader_.broken(); }

 private:
  static Result result(WireIo::Status status) noexcept {
    switch (status) {
      case WireIo::Status::Ok:
        return Result::Ok;
      case WireIo::Status::TimedOut:
        return Result::TimedOut;
      case WireIo::Status::Gone:
        return Result::Gone;
    }
    return Result::Gone;
  }

  SerialPort* port_ = nullptr;
  FrameReader<Format> reader_;
};

}  // namespace rob::drivers
