#include "drivers/serial/wire_port.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <ctime>

namespace rob::drivers {

namespace {

/// ms for poll(), rounded up, so that it does not spin before the deadline.
int poll_time(double deadline) noexcept {
  return static_cast<int>(std::ceil(std::clamp(deadline - wire_time(), 0.0, 60.0) * 1e3));
}

bool has_nothing_now(int error) noexcept {
  return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

}  // namespace

double wire_time() noexcept {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

WirePort::~WirePort() {
  if (file_ >= 0) ::close(file_);
}

std::ptrdiff_t WirePort::put(std::span<const std::uint8_t> bytes) noexcept {
  return ::write(file_, bytes.data(), bytes.size());
}

WireIo WirePort::read(std::span<std::uint8_t> into, double deadline) noexcept {
  for (;;) {
    const ssize_t count = ::read(file_, into.data(), into.size());
    if (count > 0) return {WireIo::Status::Ok, static_cast<std::size_t>(count)};
    if (count == 0 || !has_nothing_now(errno)) return {WireIo::Status::Gone, 0};
    if (wire_time() >= deadline) return {WireIo::Status::TimedOut, 0};
    pollfd waits{file_, POLLIN, 0};
    ::poll(&waits, 1, poll_time(deadline));
  }
}

WireIo WirePort::write(std::span<const std::uint8_t> bytes, double deadline) noexcept {
  std::size_t written = 0;
  while (written < bytes.size()) {
    const std::ptrdiff_t count = put(bytes.subspan(written));
    if (count > 0) {
      written += static_cast<std::size_t>(count);
      continue;
    }
    if (count < 0 && !has_nothing_now(errno)) return {WireIo::Status::Gone, written};
    if (wire_time() >= deadline) return {WireIo::Status::TimedOut, written};
    pollfd waits{file_, POLLOUT, 0};
    ::poll(&waits, 1, poll_time(deadline));
    if ((waits.revents & (POLLHUP | POLLERR)) != 0) return {WireIo::Status::Gone, written};
  }
  return {WireIo::Status::Ok, written};
}

std::size_t WirePort::discard_input() noexcept {
  std::array<std::uint8_t, 256> lost;
  std::size_t discarded = 0;
  // At most what a pseudo-terminal holds.
  for (int i = 0; i < 80; ++i) {
    const ssize_t count = ::read(file_, lost.data(), lost.size());
    if (count <= 0) break;
    discarded += static_cast<std::size_t>(count);
  }
  return discarded;
}

}  // namespace rob::drivers
