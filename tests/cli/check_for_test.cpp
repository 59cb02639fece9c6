// How far `rob check` follows a program: --for, and what it tells meanwhile.
#include <doctest/doctest.h>

#include <csignal>

#include "tests/support/pseudo_terminal.h"
#include "tests/support/rob_command.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::PseudoTerminal;
using rob::test::RobCommand;

namespace {

// 20 s there and 20 s back, for ever.
const std::string kEndless = "LOOP\nMOVE(400, 0, 0) FINE\nMOVE(0, 0, 0) FINE\nENDLOOP\n";

}  // namespace

TEST_CASE("rob check follows a program for as long as --for says") {
  const RobCommand rob(kEndless);
  struct Case {
    std::string asked;
    double seconds;
  };
  for (const Case& one : {Case{"90s", 90}, Case{"2.5min", 150}, Case{"1.5h", 5400}}) {
    CAPTURE(one.asked);
    const ProcessResult result = rob("check", {"--json", "--for", one.asked});
    CHECK(result.exit_code == 0);
    const json report = json::parse(result.out);
    // It brakes within 3 s (docs/motion.md) where it is given up.
    CHECK(report["planned_s"].get<double>() >= one.seconds);
    CHECK(report["planned_s"].get<double>() < one.seconds + 3);
    CHECK(report["findings"].back()["code"] == "N603");
    CHECK(contains(report["findings"].back()["help"], "--for 8h"));
  }
  CHECK(json::parse(rob("check", {"--json"}).out)["planned_s"].get<double>() ==
        doctest::Approx(3600).epsilon(0.001));
}

TEST_CASE("a program that ends before is foretold to its end, without a note") {
  const json report = json::parse(
      RobCommand("MOVE(400, 0, 0)\nMOVE(0, 0, 0)\n")("check", {"--json", "--for", "8h"}).out);
  CHECK(report["planned_s"].get<double>() < 60);
  CHECK(report["findings"].empty());
}

TEST_CASE("a --for that is no time is refused, with what it takes") {
  const RobCommand rob(kEndless);
  for (const std::string wrong :
       {"8", "h", "0h", "-1h", "8 h", "8hours", "300h", "1e99h", "nans", ""}) {
    CAPTURE(wrong);
    const ProcessResult result = rob("check", {"--for", wrong});
    CHECK(result.exit_code == 64);
    CHECK(result.out.empty());
    CHECK(contains(result.err, "--for"));
  }
  CHECK(contains(rob("check", {"--for", "8"}).err, "such as 90s, 20min or 8h, not '8'"));
  CHECK(rob("run", {"--fast", "--for", "8h"}).exit_code == 64);
}

TEST_CASE("how far it is stands on a terminal, and nowhere else") {
  const RobCommand rob(kEndless);
  const std::vector<std::string> line = rob.line("check", {"--for", "100h"});
  PseudoTerminal terminal(line, {});
  CHECK(terminal.expect("s, at most 360000 s"));
  terminal.signal(SIGKILL);
  CHECK_FALSE(contains(rob("check", {"--for", "2h"}).err, "at most"));
}
