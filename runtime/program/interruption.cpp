#include "runtime/program/interruption.h"

#include <csignal>

namespace rob::runtime {

namespace {

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP};

// A signal handler can reach nothing but these.
volatile std::sig_atomic_t first_signal = 0;
volatile std::sig_atomic_t ctrl_c_seen = 0;
std::atomic<std::atomic<bool>*> hold_flag{nullptr};
static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<std::atomic<bool>*>::is_always_lock_free);

void remember(int signal) {
  if (first_signal == 0) first_signal = signal;
  if (std::atomic<bool>* const hold = hold_flag.load()) hold->store(true);
}

void remember_ctrl_c(int) { ctrl_c_seen = 1; }

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption(std::atomic<bool>& hold, CtrlC ctrl_c) {
  first_signal = 0;
  ctrl_c_seen = 0;
  hold_flag = &hold;
  for (const int signal : kSignals) handle(signal, remember);
  if (ctrl_c == CtrlC::IsTold) handle(SIGINT, remember_ctrl_c);
}

Interruption::~Interruption() {
  for (const int signal : kSignals) handle(signal, SIG_DFL);
  hold_flag = nullptr;
}

bool Interruption::requested() { return first_signal != 0; }

bool Interruption::ctrl_c_pressed() {
  if (ctrl_c_seen == 0) return false;
  ctrl_c_seen = 0;
  return true;
}

ExitCode Interruption::exit_code() {
  if (first_signal == SIGTERM) return ExitCode::Terminated;
  if (first_signal == SIGHUP) return ExitCode::HungUp;
  return ExitCode::Interrupted;
}

}  // namespace rob::runtime
