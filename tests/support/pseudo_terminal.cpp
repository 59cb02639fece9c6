#include "tests/support/pseudo_terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utmp.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <system_error>
#include <thread>

#include "tests/support/child.h"

namespace rob::test {

namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kColumns = 80;

std::system_error error_of(const std::string& what) {
  return {errno, std::generic_category(), what};
}

/// In the child; only what may be called between fork() and exec().
[[noreturn]] void become(int slave, const char* folder, char* const* argv, char* const* envp) {
  die_with_parent();
  login_tty(slave);  // and leads a session, and so a process group, of its own
  if (*folder != '\0' && chdir(folder) != 0) _exit(127);
  execve(argv[0], argv, envp);
  _exit(127);
}

std::vector<std::string> environment_with(const std::map<std::string, std::string>& more) {
  std::vector<std::string> all;
  for (char** one = environ; *one != nullptr; ++one) {
    const std::string entry = *one;
    if (!more.contains(entry.substr(0, entry.find('=')))) all.push_back(entry);
  }
  for (const auto& [name, value] : more) all.push_back(name + "=" + value);
  return all;
}

std::vector<char*> pointers_to(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

int code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

PseudoTerminal::PseudoTerminal(const std::vector<std::string>& arguments, const Options& options) {
  const winsize size{24, kColumns, 0, 0};
  if (openpty(&master_, &slave_, nullptr, nullptr, &size) != 0) throw error_of("openpty");
  fcntl(master_, F_SETFD, FD_CLOEXEC);
  found_ = modes();
  const std::vector<std::string> environment = environment_with(options.environment);
  const std::vector<char*> argv = pointers_to(arguments);
  const std::vector<char*> envp = pointers_to(environment);
  child_ = fork();
  if (child_ < 0) throw error_of("fork");
  if (child_ == 0) become(slave_, options.folder.c_str(), argv.data(), envp.data());
  fcntl(slave_, F_SETFD, FD_CLOEXEC);
}

PseudoTerminal::~PseudoTerminal() {
  if (!over_) kill_group(child_);
  if (master_ >= 0) ::close(master_);
  if (slave_ >= 0) ::close(slave_);
}

void PseudoTerminal::send(std::string_view keys) {
  while (!keys.empty()) {
    const ssize_t count = ::write(master_, keys.data(), keys.size());
    if (count < 0) throw error_of("write");
    keys.remove_prefix(static_cast<std::size_t>(count));
  }
}

bool PseudoTerminal::take(std::chrono::milliseconds patience) {
  pollfd output{master_, POLLIN, 0};
  const int wait = static_cast<int>(std::max<long long>(patience.count(), 0));
  if (poll(&output, 1, wait) <= 0 || (output.revents & POLLIN) == 0) return false;
  std::array<char, 4096> part{};
  const ssize_t count = ::read(master_, part.data(), part.size());
  if (count <= 0) return false;
  raw_.append(part.data(), static_cast<std::size_t>(count));
  return true;
}

bool PseudoTerminal::expect(std::string_view text, std::chrono::milliseconds patience) {
  const auto until = Clock::now() + patience;
  for (;;) {
    const std::size_t found = raw_.find(text, seen_);
    if (found != std::string::npos) {
      seen_ = found + text.size();
      return true;
    }
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
    if (left.count() <= 0) return false;
    take(std::min<std::chrono::milliseconds>(left, 100ms));
  }
}

void PseudoTerminal::watch(std::chrono::milliseconds time) {
  const auto until = Clock::now() + time;
  while (Clock::now() < until) take(10ms);
}

std::vector<std::string> PseudoTerminal::screen() const { return shown_screen(raw_); }

std::string PseudoTerminal::last_line() const {
  std::size_t line = 0;
  const std::vector<std::string> lines = shown_screen(raw_, &line);
  return lines[line];
}

termios PseudoTerminal::modes() const {
  termios modes{};
  if (tcgetattr(slave_, &modes) != 0) throw error_of("tcgetattr");
  return modes;
}

bool PseudoTerminal::modes_as_found() const {
  const termios now = modes();
  return now.c_iflag == found_.c_iflag && now.c_oflag == found_.c_oflag &&
         now.c_cflag == found_.c_cflag && now.c_lflag == found_.c_lflag &&
         std::ranges::equal(now.c_cc, found_.c_cc);
}

void PseudoTerminal::resize(unsigned short lines, unsigned short columns) {
  const winsize size{lines, columns, 0, 0};
  if (ioctl(master_, TIOCSWINSZ, &size) != 0) throw error_of("TIOCSWINSZ");
}

void PseudoTerminal::signal(int number) const { ::kill(child_, number); }

void PseudoTerminal::hang_up() {
  ::close(slave_);
  ::close(master_);
  master_ = slave_ = -1;
}

int PseudoTerminal::wait(std::chrono::milliseconds patience) {
  const auto until = Clock::now() + patience;
  int status = 0;
  while (::waitpid(child_, &status, WNOHANG) == 0) {
    if (Clock::now() > until) return -1;
    // What nobody reads would stop it.
    if (master_ < 0 || !take(10ms)) std::this_thread::sleep_for(5ms);
  }
  over_ = true;
  while (master_ >= 0 && take(0ms)) continue;
  return code_of(status);
}

namespace {

/// A screen that grows downwards; lines in bytes of UTF-8, a character a cell.
class Cells {
 public:
  void put(std::string_view bytes);
  std::vector<std::string> lines() const;
  std::size_t line() const { return line_; }

 private:
  using Line = std::vector<std::string>;
  std::size_t control(std::string_view bytes);
  void carry_out(char command, std::size_t number);
  void put_character(std::string character);
  Line& here() {
    if (lines_.size() <= line_) lines_.resize(line_ + 1);
    return lines_[line_];
  }

  std::vector<Line> lines_{1};
  std::size_t line_ = 0;
  std::size_t column_ = 0;
};

/// From behind the escape; the bytes that belong to the sequence.
std::size_t Cells::control(std::string_view bytes) {
  if (bytes.empty() || bytes.front() != '[') return std::min<std::size_t>(bytes.size(), 1);
  std::size_t end = 1;
  std::size_t number = 0;
  while (end < bytes.size() && (bytes[end] < '@' || bytes[end] > '~')) {
    if (bytes[end] >= '0' && bytes[end] <= '9')
      number = 10 * number + static_cast<std::size_t>(bytes[end] - '0');
    ++end;
  }
  if (end == bytes.size()) return end;
  carry_out(bytes[end], number);
  return end + 1;
}

void Cells::carry_out(char command, std::size_t number) {
  const std::size_t steps = std::max<std::size_t>(number, 1);
  Line& line = here();
  if (command == 'A') line_ -= std::min(line_, steps);
  if (command == 'B') line_ += steps;
  if (command == 'C') column_ += steps;
  if (command == 'D') column_ -= std::min(column_, steps);
  if (command == 'K' || command == 'J') line.resize(std::min(line.size(), column_));
  if (command == 'J') lines_.resize(line_ + 1);
}

void Cells::put_character(std::string character) {
  if (column_ == kColumns) {
    column_ = 0;
    ++line_;
  }
  Line& line = here();
  if (line.size() <= column_) line.resize(column_ + 1, " ");
  line[column_++] = std::move(character);
}

void Cells::put(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto c = static_cast<unsigned char>(bytes[i]);
    if (c == '\033') {
      i += control(bytes.substr(i + 1));
    } else if (c == '\r') {
      column_ = 0;
    } else if (c == '\n') {
      ++line_;
      here();
    } else if (c == '\b') {
      column_ -= std::min<std::size_t>(column_, 1);
    } else if (c >= ' ') {
      std::size_t length = 1;  // of a character of UTF-8: the bytes 10xxxxxx go on with it
      while (i + length < bytes.size() && (bytes[i + length] & 0xC0) == 0x80) ++length;
      put_character(std::string(bytes.substr(i, length)));
      i += length - 1;
    }
  }
}

std::vector<std::string> Cells::lines() const {
  std::vector<std::string> texts;
  for (const Line& line : lines_) {
    std::string text;
    for (const std::string& cell : line) text += cell;
    text.erase(text.find_last_not_of(' ') + 1);
    texts.push_back(std::move(text));
  }
  return texts;
}

}  // namespace

std::vector<std::string> shown_screen(std::string_view bytes, std::size_t* cursor_line) {
  Cells cells;
  cells.put(bytes);
  if (cursor_line != nullptr) *cursor_line = cells.line();
  return cells.lines();
}

}  // namespace rob::test
