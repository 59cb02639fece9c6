#include "runtime/prompt/terminal_guard.h"

#include <termios.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <string_view>

namespace rob::runtime {

namespace {

constexpr int kCrashes[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP};

// A signal handler can reach nothing but these.
termios found{};
volatile std::sig_atomic_t changed = 0;
volatile std::sig_atomic_t ctrl_z = 0;
std::atomic<const char*> parting{nullptr};

void send(std::string_view text) {
  if (write(STDOUT_FILENO, text.data(), text.size()) < 0) changed = 0;  // the terminal is gone
}

void give_back() {
  if (changed == 0) return;
  if (const char* const text = parting.exchange(nullptr)) send(text);
  changed = 0;
  tcsetattr(STDIN_FILENO, TCSANOW, &found);
}

/// The signal does then what it does without a handler.
void give_back_and_die(int signal) {
  const bool was_changed = changed != 0;
  give_back();
  if (was_changed) {
    // A paste is no longer marked; the shell goes on in a line of its own.
    constexpr std::string_view kPlain = "\033[?2004l\r\n";
    send(kPlain);
  }
  raise(signal);
}

void note_ctrl_z() {
  struct sigaction action {};
  action.sa_handler = [](int) { ctrl_z = 1; };
  action.sa_flags = SA_RESTART;
  sigaction(SIGTSTP, &action, nullptr);
}

}  // namespace

bool TerminalGuard::take_suspension() {
  const bool asked = ctrl_z != 0;
  ctrl_z = 0;
  return asked;
}

void TerminalGuard::suspend() {
  termios now{};
  const bool known = tcgetattr(STDIN_FILENO, &now) == 0;
  send("\033[?2004l");
  tcsetattr(STDIN_FILENO, TCSADRAIN, &found);
  std::signal(SIGTSTP, SIG_DFL);
  raise(SIGTSTP);
  note_ctrl_z();
  if (known) tcsetattr(STDIN_FILENO, TCSADRAIN, &now);
  send("\033[?2004h");
}

void TerminalGuard::send_at_end(const char* text) { parting = text; }

TerminalGuard::TerminalGuard() {
  changed = tcgetattr(STDIN_FILENO, &found) == 0 ? 1 : 0;
  static const int registered = std::atexit(give_back);
  static_cast<void>(registered);
  struct sigaction action {};
  action.sa_handler = give_back_and_die;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_NODEFER;
  for (const int signal : kCrashes) sigaction(signal, &action, nullptr);
  note_ctrl_z();
}

TerminalGuard::~TerminalGuard() {
  give_back();
  for (const int signal : kCrashes) std::signal(signal, SIG_DFL);
  std::signal(SIGTSTP, SIG_DFL);
}

}  // namespace rob::runtime
