#include "runtime/program/interruption.h"

#include <doctest/doctest.h>

#include <atomic>
#include <csignal>

using rob::runtime::ExitCode;
using rob::runtime::Interruption;

TEST_CASE("a signal asks for the stop by itself, whatever the program's threads are doing") {
  struct Case {
    int signal;
    ExitCode code;
  };
  for (const Case c : {Case{SIGINT, ExitCode::Interrupted}, Case{SIGTERM, ExitCode::Terminated},
                       Case{SIGHUP, ExitCode::HungUp}}) {
    std::atomic<bool> hold{false};
    const Interruption interruption(hold);
    CHECK_FALSE(hold);
    CHECK_FALSE(Interruption::requested());
    std::raise(c.signal);
    CHECK(hold);
    CHECK(Interruption::requested());
    CHECK(Interruption::exit_code() == c.code);
  }
}

TEST_CASE("of several signals the first gives the exit code") {
  std::atomic<bool> hold{false};
  const Interruption interruption(hold);
  std::raise(SIGTERM);
  std::raise(SIGINT);
  CHECK(Interruption::exit_code() == ExitCode::Terminated);
}
