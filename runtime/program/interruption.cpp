#include "runtime/program/interruption.h"

#include <csignal>

namespace rob::runtime {

namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

// A signal handler can reach nothing but this.
volatile std::sig_atomic_t first_signal = 0;

void remember(int signal) {
  if (first_signal == 0) first_signal = signal;
}

void handle_with(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  for (const int signal : kSignals) sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption() {
  first_signal = 0;
  handle_with(remember);
}

Interruption::~Interruption() { handle_with(SIG_DFL); }

bool Interruption::requested() { return first_signal != 0; }

ExitCode Interruption::exit_code() {
  if (first_signal == SIGTERM) return ExitCode::Terminated;
  if (first_signal == SIGHUP) return ExitCode::HungUp;
  return ExitCode::Interrupted;
}

}  // namespace rob::runtime
