#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace rob::drivers {

/// s on CLOCK_MONOTONIC: what the time limits of a wire are told in.
double wire_time() noexcept;

/// What became of reading from a wire or writing to it.
struct WireIo {
  enum class Status : std::uint8_t { Ok, TimedOut, Gone };
  Status status = Status::Ok;
  std::size_t bytes = 0;
};

/// A serial port of this computer: raw, 8 data bits, no parity, one stop bit, no flow control; held
/// by this process alone. TIOCEXCL keeps others out, flock() keeps out root too and tells who holds
/// it. Nothing waits longer than its deadline, and a port that has vanished is never opened again.
class SerialPort {
 public:
  /// Throws motion::DriverError that says what to do: no such port (the ports that there are), not
  /// permitted (the group), used already (by which process), no serial port, a speed it has not.
  SerialPort(const std::string& path, int baud);
  ~SerialPort();
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  /// What has come, as soon as there is anything, by wire_time() `deadline` at the latest; what is
  /// there when this thread wakes up too late is still read.
  WireIo read(std::span<std::uint8_t> into, double deadline) noexcept;
  /// All of `bytes`, or TimedOut with how many could be handed over.
  WireIo write(std::span<const std::uint8_t> bytes, double deadline) noexcept;
  /// Forgets what has come and was not read: a late answer to an old question.
  void discard_input() noexcept;

  const std::string& path() const noexcept { return path_; }
  /// A USB adapter collects bytes for that long, ms; 0 where the port does not say. More than 1
  /// breaks a cycle of 10 ms.
  int latency_timer() const noexcept { return latency_timer_; }

 private:
  void configure(int baud);

  std::string path_;
  int file_ = -1;
  int latency_timer_ = 0;
};

}  // namespace rob::drivers
