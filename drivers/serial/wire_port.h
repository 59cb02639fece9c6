#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace rob::drivers {

/// s on CLOCK_MONOTONIC: the clock of all deadlines of a wire.
double wire_time() noexcept;

/// The outcome of reading from a wire or writing to it.
struct WireIo {
  enum class Status : std::uint8_t { Ok, TimedOut, Gone };
  Status status = Status::Ok;
  std::size_t bytes = 0;
};

/// Bytes to a machine and back: a serial port (SerialPort) or a network connection (TcpPort). No
/// call waits longer than its deadline. A wire that has gone stays gone: it is never opened again.
class WirePort {
 public:
  virtual ~WirePort();
  WirePort(const WirePort&) = delete;
  WirePort& operator=(const WirePort&) = delete;

  /// Returns as soon as there is anything to read, at wire_time() `deadline` at the latest. If this
  /// thread wakes up after the deadline, it still reads what has arrived.
  WireIo read(std::span<std::uint8_t> into, double deadline) noexcept;
  /// All of `bytes`, or TimedOut with the number that could be handed over.
  WireIo write(std::span<const std::uint8_t> bytes, double deadline) noexcept;
  /// Drops what has arrived and was not read; returns the number of bytes.
  std::size_t discard_input() noexcept;

  /// As the user wrote it: "/dev/ttyUSB0", "tcp://host:23".
  const std::string& path() const noexcept { return path_; }

 protected:
  explicit WirePort(const std::string& path) : path_(path) {}
  /// Takes over an open, non-blocking descriptor.
  void take(int file) noexcept { file_ = file; }
  int file() const noexcept { return file_; }
  /// As ::write().
  virtual std::ptrdiff_t put(std::span<const std::uint8_t> bytes) noexcept;

 private:
  std::string path_;
  int file_ = -1;
};

}  // namespace rob::drivers
