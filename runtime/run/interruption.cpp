#include "runtime/run/interruption.h"

#include <csignal>

namespace rob::runtime {

namespace {

/// Those whose default action ends the process, without the crashes.
constexpr int kSignals[] = {SIGHUP,    SIGINT,  SIGQUIT, SIGTERM, SIGUSR1, SIGUSR2,  SIGALRM,
                            SIGVTALRM, SIGPROF, SIGIO,   SIGPWR,  SIGXCPU, SIGSTKFLT};

// A signal handler can reach nothing but these.
volatile std::sig_atomic_t first_signal = 0;
volatile std::sig_atomic_t ctrl_c_count = 0;  // 2: twice or more
volatile std::sig_atomic_t tells_ctrl_c = 0;
std::atomic<StopRequests*> innermost{nullptr};
static_assert(std::atomic<bool>::is_always_lock_free);
static_assert(std::atomic<StopRequests*>::is_always_lock_free);

void remember(int signal) {
  StopRequests* const requests = innermost.load();
  const bool by_key = signal == SIGINT || (signal == SIGQUIT && tells_ctrl_c != 0);
  if (by_key) {
    const bool again = ctrl_c_count > 0;
    ctrl_c_count = again ? 2 : 1;
    if (tells_ctrl_c != 0) return;
    if (again && requests != nullptr) requests->brake.store(true);
  }
  if (first_signal == 0) first_signal = signal;
  if (requests != nullptr) requests->hold.store(true);
}

void handle_all(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  for (const int signal : kSignals) sigaction(signal, &action, nullptr);
  for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal) sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption(StopRequests& requests, CtrlC ctrl_c)
    : outer_(innermost.load()), outer_tells_(tells_ctrl_c != 0) {
  if (outer_ == nullptr) first_signal = 0;
  if (outer_ == nullptr) ctrl_c_count = 0;
  tells_ctrl_c = ctrl_c == CtrlC::IsTold ? 1 : 0;
  innermost = &requests;
  if (outer_ == nullptr) handle_all(remember);
  if (requested()) requests.hold = true;
  if (requested() && ctrl_c_count > 1) requests.brake = true;
}

Interruption::~Interruption() {
  if (outer_ == nullptr) handle_all(SIG_DFL);
  innermost = outer_;
  tells_ctrl_c = outer_tells_ ? 1 : 0;
}

bool Interruption::requested() { return first_signal != 0; }

bool Interruption::ctrl_c_pressed() {
  const bool seen = ctrl_c_count != 0;
  ctrl_c_count = 0;
  return seen;
}

ExitCode Interruption::exit_code() {
  constexpr int kOfSignals = 128;  // as a shell reports the end by a signal
  return static_cast<ExitCode>(kOfSignals + first_signal);
}

}  // namespace rob::runtime
