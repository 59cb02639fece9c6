#include "runtime/run/interruption.h"

#include <doctest/doctest.h>

#include <csignal>

using rob::runtime::ExitCode;
using rob::runtime::Interruption;
using rob::runtime::StopRequests;

TEST_CASE("a signal asks for the stop by itself, whatever the program's threads are doing") {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGALRM, SIGVTALRM,
                           SIGPROF, SIGIO, SIGPWR, SIGXCPU, SIGSTKFLT, SIGRTMIN, SIGRTMAX}) {
    CAPTURE(signal);
    StopRequests requests;
    const Interruption interruption(requests);
    CHECK_FALSE(requests.hold);
    CHECK_FALSE(Interruption::requested());
    std::raise(signal);
    CHECK(requests.hold);
    CHECK_FALSE(requests.brake);
    CHECK(Interruption::requested());
    CHECK(static_cast<int>(Interruption::exit_code()) == 128 + signal);
  }
}

TEST_CASE("of several signals the first gives the exit code") {
  StopRequests requests;
  const Interruption interruption(requests);
  std::raise(SIGTERM);
  std::raise(SIGINT);
  CHECK(Interruption::exit_code() == ExitCode::Terminated);
  CHECK_FALSE(requests.brake);
}

TEST_CASE("a second Ctrl-C asks for the hardest brake") {
  StopRequests requests;
  const Interruption interruption(requests);
  std::raise(SIGINT);
  CHECK_FALSE(requests.brake);
  std::raise(SIGINT);
  CHECK(requests.brake);
}

TEST_CASE("where Ctrl-C is only told it stops nothing, and is told once") {
  StopRequests requests;
  const Interruption interruption(requests, Interruption::CtrlC::IsTold);
  CHECK_FALSE(Interruption::ctrl_c_pressed());
  std::raise(SIGINT);
  std::raise(SIGINT);
  CHECK(Interruption::ctrl_c_pressed());
  CHECK_FALSE(Interruption::ctrl_c_pressed());
  CHECK_FALSE(requests.hold);
  CHECK_FALSE(Interruption::requested());
}

TEST_CASE("what came before an inner interruption began is there at once, and stays behind it") {
  StopRequests outer;
  const Interruption around(outer);
  std::raise(SIGTERM);
  {
    StopRequests inner;
    const Interruption within(inner);
    CHECK(inner.hold);
    CHECK_FALSE(inner.brake);
    outer.hold = false;
    std::raise(SIGUSR1);
    CHECK_FALSE(outer.hold);  // the inner one's is written
  }
  CHECK(Interruption::exit_code() == ExitCode::Terminated);
  std::raise(SIGUSR1);  // still no end of the process
  CHECK(outer.hold);
}
