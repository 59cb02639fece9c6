// `rob run` and `rob check` from outside: documents, traces, real time and signals.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <sstream>
#include <thread>

#include "tests/support/rob_command.h"
#include "tests/support/trace_rows.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::lines_in;
using rob::test::Process;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::wait_until_it_moves;
using namespace std::chrono_literals;

namespace {

constexpr const char* kTriangle =
    "MOVE(40,40,0)\nMOVE(140,40,0)\nMOVE(90,126,0)\nMOVE(40,40,0)\nSTOP\nEND\n";

/// The greatest step of an axis between two rows, mm or deg: a jump would show.
double greatest_step(const std::string& trace, std::size_t axes) {
  std::ifstream file(trace);
  std::string line;
  std::getline(file, line);
  std::vector<double> before;
  double most = 0;
  while (std::getline(file, line)) {
    std::istringstream row(line);
    std::vector<double> values;
    for (std::string field; std::getline(row, field, ',');) values.push_back(std::stod(field));
    for (std::size_t i = 0; i < axes && !before.empty(); ++i) {
      most = std::max(most, std::abs(values.at(9 + i) - before.at(9 + i)));
    }
    before = values;
  }
  return most;
}

}  // namespace

TEST_CASE("the check table is the one that the manual promises") {
  const ProcessResult result = RobCommand(kTriangle)("check");
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  CHECK(result.out ==
        "   line  starts   takes   decides at   corner missed by\n"
        "     1    0.00     2.75       2.75       4.0 mm\n"
        "     2    2.75     5.00       7.75       9.6 mm\n"
        "     3    7.75     4.30      12.05      10.3 mm\n"
        "     4   12.05     4.30      16.35       0.0 mm   (STOP)\n"
        "     5   16.35     2.75                           total 19.10 s\n");
}

TEST_CASE("two runs on the virtual clock write the same trace, byte for byte") {
  const RobCommand rob(kTriangle);
  CHECK(rob("run", {"--fast", "--trace", rob.file("a.csv")}).exit_code == 0);
  CHECK(rob("run", {"--fast", "--trace", rob.file("b.csv")}).exit_code == 0);
  CHECK(rob::test::read_whole_file(rob.file("a.csv")) ==
        rob::test::read_whole_file(rob.file("b.csv")));
  CHECK(lines_in(rob.file("a.csv")) == 1912);  // header and 1911 rows
}

TEST_CASE("--law counts before LAW, and LAW before the robot's file") {
  const auto law_of = [](const std::string& text, const std::vector<std::string>& option = {}) {
    std::vector<std::string> options{"--fast", "--json"};
    options.insert(options.end(), option.begin(), option.end());
    const json report = json::parse(RobCommand(text)("run", options).out);
    return report["law"].get<std::string>();
  };
  const std::string move = "MOVE(10, 0, 0)\n";
  CHECK(law_of(move) == "paul");  // the gantry's
  CHECK(law_of("LAW LOOKAHEAD\n" + move) == "lookahead");
  CHECK(law_of(move, {"--law", "lookahead"}) == "lookahead");
  CHECK(law_of("LAW LOOKAHEAD\n" + move, {"--law", "paul"}) == "paul");
}

TEST_CASE("RANDOM is the same in every run with the same --seed, and another with another") {
  const RobCommand rob("PRINT RANDOM(1, 1000000)\n");
  const std::string drawn = rob("run", {"--fast", "--seed", "7"}).out;
  CHECK(rob("run", {"--fast", "--seed", "7"}).out == drawn);
  CHECK(rob("run", {"--fast", "--seed", "8"}).out != drawn);
  CHECK(rob("run", {"--fast", "--seed", "-1"}).exit_code == 64);
}

TEST_CASE("with --json standard output is one document, whatever the program prints") {
  const ProcessResult result = RobCommand(
      "PRINT \"a \\\"quoted\\\" line\"\nMOVE(10,0,0)\nPRINT 20mm\n")("run", {"--fast", "--json"});
  const json report = json::parse(result.out);
  CHECK(report["output"] == json::array({"a \"quoted\" line", "20mm"}));
  CHECK(report["clock"] == "virtual");
  CHECK(report["final"]["joints"][0] == 10.0);
}

TEST_CASE("the report tells the way of each line, and how far the path was left") {
  const auto report = [](const char* program) {
    return json::parse(RobCommand(program)("run", {"--fast", "--json"}).out);
  };
  const json straight = report("MOVE(30,40,0) FINE\nMOVE(130,40,0) FINE\nMOVE(130,40,0) FINE\n");
  CHECK(straight["lines"][0]["s_mm"] == doctest::Approx(50));  // 3, 4, 5
  CHECK(straight["lines"][1]["s_mm"] == doctest::Approx(100));
  CHECK(straight["lines"][2]["s_mm"] == 0);
  CHECK(straight["deviation_mm"] == doctest::Approx(0).epsilon(1e-5));

  const json triangle = report(kTriangle);
  double most = 0;
  for (const json& line : triangle["lines"]) {
    if (!line["corner_miss_mm"].is_object()) continue;
    most = std::max(most, line["corner_miss_mm"]["planned"].get<double>());
  }
  CHECK(most > 1);
  CHECK(triangle["deviation_mm"] == doctest::Approx(most));
}

TEST_CASE("an event tells where the axes were") {
  const RobCommand command("MOVE(300,0,0) UNTIL HERE.x > 100mm\n");
  const json report = json::parse(command("run", {"--fast", "--json"}).out);
  REQUIRE(report["events"].size() == 1);
  const json& hit = report["events"][0];
  CHECK(hit["kind"] == "hit");
  REQUIRE(hit["q"].size() == 3);
  const double there = hit["q"][0];
  const double at_rest = report["final"]["joints"][0];
  // Braking from v = 20 mm/s within a = 100 mm/s² and j = 1000 mm/s³ takes v/2·(v/a + a/j) = 3 mm
  // at least, behind at most two cycles of 0.2 mm; the ramp of the path may take half as long
  // again.
  CHECK(at_rest - there > 3);
  CHECK(at_rest - there < 4.9);
  CHECK(report["lines"][0]["s_mm"] == doctest::Approx(at_rest));
}

TEST_CASE("a run-time error tells its line, exit code 70, behind what was commanded before") {
  const ProcessResult result =
      RobCommand("VAR n = 0\nMOVE(10,0,0)\nPRINT \"before\"\nPRINT 1 / n\nPRINT \"after\"\n")(
          "run", {"--fast", "--json"});
  CHECK(result.exit_code == 70);
  const json report = json::parse(result.out);
  CHECK(report["output"] == json::array({"before"}));
  CHECK(report["error"]["line"] == 4);
  CHECK(report["final"]["joints"][0] == 10.0);
}

TEST_CASE("a run-time error tells the calls that led to it, and where the robot stands") {
  const RobCommand rob("PROC go(n: INT)\nMOVE(100, 50, 90)\nPRINT 1 / n\nENDPROC\ngo(0)\n");
  const std::string run = rob("run", {"--fast"}).err;
  CHECK(contains(run, "  in go, called in line 5\n"));
  CHECK(contains(run, "  the robot stands at x 100 mm, y 50 mm, theta 90 deg\n"));
  const std::string check = rob("check").err;
  CHECK(contains(check, "  in go, called in line 5\n"));
  CHECK_FALSE(contains(check, "the robot stands"));
}

TEST_CASE(
    "an error that shows only in the computation is foretold, and is a finding of the check") {
  const ProcessResult result =
      RobCommand("VAR far = 500mm\nMOVE(10,0,0)\nMOVE(far,0,0)\n")("check", {"--json"});
  CHECK(result.exit_code == 65);
  const json report = json::parse(result.out);
  REQUIRE(report["findings"].size() == 1);
  CHECK(report["findings"][0]["severity"] == "error");
  CHECK(report["findings"][0]["line"] == 3);
  CHECK(report["findings"][0]["message"] == report["error"]["message"]);
}

TEST_CASE("a program of more than an hour is foretold for an hour, and a note says so") {
  std::string text;  // 190 lines of 20 s each
  for (int i = 0; i < 190; ++i) text += i % 2 == 0 ? "MOVE(400,0,0)\n" : "MOVE(0,0,0)\n";
  const json report = json::parse(RobCommand(text)("check", {"--json"}).out);
  CHECK(report["status"] == "done");
  REQUIRE(report["findings"].size() == 1);
  CHECK(report["findings"][0]["severity"] == "note");
  CHECK(contains(report["findings"][0]["message"], "beyond the 3600 s that were foretold"));
  CHECK(report["planned_s"] >= 3600.0);
  CHECK(report["planned_s"] <= 3640.0);  // at most the two lines that the buffer had begun
}

TEST_CASE("behind a program that failed while it ran no other is started") {
  const RobCommand bad("VAR n = 0\nPRINT 1 / n\n");
  const RobCommand good("PRINT \"started\"\n");
  const ProcessResult result = bad("run", {good.program(), "--fast"});
  CHECK(result.exit_code == 70);
  CHECK_FALSE(contains(result.out, "started"));
}

TEST_CASE("faults 35 and 36: Ctrl-C, SIGTERM and SIGHUP stop on the path, then exit") {
  struct Case {
    int signal;
    int exit_code;
  };
  for (const Case c : {Case{SIGINT, 130}, Case{SIGTERM, 143}, Case{SIGHUP, 129}}) {
    const RobCommand rob(kTriangle);
    const std::string trace = rob.file("t.csv");
    Process run(rob.line("run", {"--json", "--trace", trace}));
    wait_until_it_moves(trace);
    run.send(c.signal);
    const ProcessResult result = run.wait();
    CHECK(result.exit_code == c.exit_code);
    const json report = json::parse(result.out);  // not killed: it told its result
    CHECK(report["status"] != "done");
    CHECK(greatest_step(trace, 3) <= 0.2 + 1e-9);  // 20 mm/s in 10 ms
    // Line 1 goes along the diagonal: a stop on the path stands on it.
    if (report["measured_s"] < 2.75) {
      CHECK(report["final"]["joints"][0] == report["final"]["joints"][1]);
    }
  }
}

TEST_CASE("fault 37: the start behind a run that was killed says so, once") {
  const RobCommand rob(kTriangle);
  const RobCommand after("PRINT 1\n");
  const std::string trace = rob.file("t.csv");
  Process run(rob.line("run", {"--trace", trace}));
  wait_until_it_moves(trace);
  CHECK_FALSE(contains(after("run").err, "unclean end"));  // it still runs
  run.send(SIGKILL);
  CHECK(run.wait().exit_code == 128 + SIGKILL);
  const std::string told = after("run").err;
  CHECK(contains(told, "unclean end: the run of " + rob.program() + " on gantry"));
  CHECK(contains(told, "look where the robot stands"));
  CHECK_FALSE(contains(after("run").err, "unclean end"));
}

TEST_CASE("fault 37: a run that cannot be marked runs, and says so") {
  const RobCommand rob("PRINT 1\n");
  std::ofstream(rob.states()) << "a file, no folder";
  const ProcessResult result = rob("run");
  CHECK(result.exit_code == 0);
  CHECK(contains(result.err, "should this run be killed, the next start will not say so"));
  CHECK_FALSE(contains(rob("run", {"--fast"}).err, "killed"));
}

TEST_CASE("fault 13: an endless loop without motion ends at Ctrl-C") {
  const RobCommand rob("MOVE(10,0,0)\nWHILE TRUE DO\nENDWHILE\n");
  Process run(rob.line("run", {"--json", "--trace", rob.file("t.csv")}));
  wait_until_it_moves(rob.file("t.csv"));
  run.send(SIGINT);
  CHECK(run.wait().exit_code == 130);
}

TEST_CASE("faults 16 and 38: a process that was stopped holds the robot where it was") {
  const RobCommand rob(kTriangle);
  const std::string trace = rob.file("t.csv");
  Process run(rob.line("run", {"--json", "--trace", trace}));
  wait_until_it_moves(trace);
  run.send(SIGSTOP);
  std::this_thread::sleep_for(1s);
  run.send(SIGCONT);
  const ProcessResult result = run.wait();
  CHECK(result.exit_code == 70);
  const json report = json::parse(result.out);
  CHECK(report["status"] == "fault");
  CHECK(report["error"]["code"] == "E501");
  // References go on from the last one sent: no step is longer than v_max in the periods made up.
  CHECK(greatest_step(trace, 3) <= 20 * 0.2 + 1e-9);
}
