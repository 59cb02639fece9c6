#include "runtime/prompt/raw_terminal.h"

#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

#include "runtime/program/files.h"

namespace rob::runtime {

namespace {

/// The other screen, no cursor; and back, with the keyboard as it was (key_reader.h).
constexpr std::string_view kEnter = "\x1b[?1049h\x1b[?25l";
constexpr std::string_view kLeave = "\x1b[<u\x1b[?25h\x1b[?1049l";

/// By these a process ends that has gone wrong.
constexpr std::array kCrashes = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

termios before{};
std::array<struct sigaction, kCrashes.size()> handlers_before{};

void put(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(STDOUT_FILENO, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;  // the terminal is gone: read() says so
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void give_back() {
  put(kLeave);
  ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &before);
}

/// What it calls may be called in a handler. Who was there before has the signal next.
void give_back_and_end(int signal) {
  give_back();
  for (std::size_t i = 0; i < kCrashes.size(); ++i) {
    if (kCrashes[i] == signal) ::sigaction(signal, &handlers_before[i], nullptr);
  }
  std::raise(signal);
}

winsize size_of_terminal() {
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return {24, 80, 0, 0};
  return size;
}

}  // namespace

RawTerminal::RawTerminal() {
  if (::isatty(STDOUT_FILENO) == 0 || ::tcgetattr(STDIN_FILENO, &before) != 0)
    throw FileError("the pendant needs a terminal");
  termios raw = before;
  ::cfmakeraw(&raw);
  raw.c_lflag |= ISIG;  // Ctrl-C stays what it is
  ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &raw);
  for (std::size_t i = 0; i < kCrashes.size(); ++i) {
    struct sigaction action {};
    action.sa_handler = give_back_and_end;
    ::sigaction(kCrashes[i], &action, &handlers_before[i]);
  }
  put(kEnter);
}

RawTerminal::~RawTerminal() {
  give_back();
  for (std::size_t i = 0; i < kCrashes.size(); ++i)
    ::sigaction(kCrashes[i], &handlers_before[i], nullptr);
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
