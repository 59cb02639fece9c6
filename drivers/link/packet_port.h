#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "drivers/protocol/frame_reader.h"
#include "drivers/serial/wire_port.h"

namespace rob::drivers {

/// Packets of one format on a port.
template <typename Format>
class PacketPort {
 public:
  using Frame = typename Format::Frame;
  enum class Result : std::uint8_t { Ok, TimedOut, Gone };

  void attach(WirePort& port) {
    port_ = &port;
    reader_.clear();
    echo_.clear();
    echoes_ = false;
  }
  const WirePort& port() const noexcept { return *port_; }

  /// Whether the adapter gives back all that is sent through it, as some do on a bus of one wire.
  /// If so, removes the echo from here on. `question`: a packet that no device answers.
  bool find_echo(Bytes question, double deadline) noexcept {
    echoes_ = false;
    ask(question, deadline);
    std::array<std::uint8_t, Format::kMost> back{};
    std::size_t got = 0;
    while (got < question.size()) {
      const std::span left = std::span(back).first(question.size()).subspan(got);
      const WireIo io = port_->read(left, deadline);
      if (io.status != WireIo::Status::Ok) break;
      got += io.bytes;
    }
    echoes_ = got == question.size() && std::equal(question.begin(), question.end(), back.begin());
    return echoes_;
  }

  Result send(Bytes bytes, double deadline) noexcept {
    if (echoes_) echo_.push(bytes);
    return result(port_->write(bytes, deadline).status);
  }
  /// The same, but first forgets all bytes received before, so that no late answer is mistaken for
  /// this one.
  Result ask(Bytes bytes, double deadline) noexcept {
    port_->discard_input();
    reader_.clear();
    echo_.clear();
    return send(bytes, deadline);
  }
  /// The next whole packet.
  Result receive(Frame& frame, double deadline) noexcept {
    std::array<std::uint8_t, 256> bytes;
    while (!reader_.next(frame)) {
      const WireIo io = port_->read(bytes, deadline);
      if (io.status != WireIo::Status::Ok) return result(io.status);
      reader_.add(without_echo({bytes.data(), io.bytes}));
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

  /// Removes the echo of the sent bytes from the front. The first byte that differs ends the echo.
  Bytes without_echo(Bytes bytes) noexcept {
    std::size_t same = 0;
    const std::size_t most = std::min(bytes.size(), echo_.size());
    while (same < most && bytes[same] == echo_[same]) ++same;
    if (same == most) {
      echo_.drop(same);
    } else {
      echo_.clear();
    }
    return bytes.subspan(same);
  }

  WirePort* port_ = nullptr;
  FrameReader<Format> reader_;
  ByteBuffer<3 * Format::kMost> echo_;  ///< sent, and not come back yet
  bool echoes_ = false;
};

}  // namespace rob::drivers
