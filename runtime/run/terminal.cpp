#include "runtime/run/terminal.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <utility>

namespace rob::runtime {

bool Terminal::present() { return !over_ && isatty(STDIN_FILENO) != 0; }

void Terminal::listen() {
  typed_.clear();
  if (present()) tcflush(STDIN_FILENO, TCIFLUSH);
}

/// A terminal hands out whole lines; a long one comes in parts.
std::optional<std::string> Terminal::line() {
  // Reading from the background would stop the whole process.
  if (tcgetpgrp(STDIN_FILENO) != getpgrp()) return std::nullopt;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (poll(&input, 1, waits_ ? -1 : 0) <= 0) return std::nullopt;
  std::array<char, 256> part{};
  const ssize_t count = read(STDIN_FILENO, part.data(), part.size());
  if (count <= 0) {
    over_ = true;
    return std::nullopt;
  }
  typed_.append(part.data(), static_cast<std::size_t>(count));
  if (typed_.back() != '\n') return std::nullopt;
  typed_.pop_back();
  return std::exchange(typed_, {});
}

}  // namespace rob::runtime
