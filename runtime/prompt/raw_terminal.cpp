#include "runtime/prompt/raw_terminal.h"

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>

#include "runtime/files/files.h"
#include "runtime/prompt/terminal_guard.h"

namespace rob::runtime {

namespace {

/// The other screen, no cursor; and back, with the keyboard as it was (key_reader.h).
constexpr std::string_view kEnter = "\x1b[?1049h\x1b[?25l";
constexpr const char* kLeave = "\x1b[<u\x1b[?25h\x1b[?1049l";

termios modes_before{};

void put(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;  // the terminal is gone: read() says so
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

winsize size_of_terminal() {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return {24, 80, 0, 0};
  return size;
}

}  // namespace

RawTerminal::RawTerminal() {
  if (::isatty(STDOUT_FILENO) == 0 || ::tcgetattr(STDIN_FILENO, &modes_before) != 0)
    throw FileError("the pendant needs a terminal");
  termios raw = modes_before;
  ::cfmakeraw(&raw);
  raw.c_lflag |= ISIG;  // Ctrl-C stays what it is
  ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &raw);
  TerminalGuard::send_at_end(kLeave);
  put(kEnter);
}

RawTerminal::~RawTerminal() {
  TerminalGuard::send_at_end(nullptr);
  put(kLeave);
  ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &modes_before);
}

std::optional<std::string> RawTerminal::read(int milliseconds) {
  if (gone_) return std::nullopt;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (::poll(&input, 1, milliseconds) <= 0) return "";
  std::array<char, 256> bytes{};
  const ssize_t count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
  if (count < 0 && (errno == EINTR || errno == EAGAIN)) return "";
  gone_ = count <= 0;
  if (gone_) return std::nullopt;
  return std::string(bytes.data(), static_cast<std::size_t>(count));
}

void RawTerminal::write(std::string_view text) { put(text); }

void RawTerminal::show(std::string_view lines) {
  std::string text = "\x1b[H";
  for (const char c : lines) text += c == '\n' ? std::string("\x1b[K\r\n") : std::string(1, c);
  put(text + "\x1b[K\x1b[J");
}

int RawTerminal::columns() const { return size_of_terminal().ws_col; }
int RawTerminal::rows() const { return size_of_terminal().ws_row; }

}  // namespace rob::runtime
