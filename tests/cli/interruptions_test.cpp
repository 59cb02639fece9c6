// What the system can do to a run: signals, limits of files and memory, readers that go away.
#include <doctest/doctest.h>

#include <cmath>
#include <csignal>
#include <memory>
#include <sstream>

#include "tests/support/rob_command.h"
#include "tests/support/trace_rows.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::kXSpeed;
using rob::test::newest_row;
using rob::test::Process;
using rob::test::ProcessResult;
using rob::test::read_whole_file;
using rob::test::RobCommand;
using rob::test::run_process;
using rob::test::wait_for_row;

namespace {

/// Along the diagonal of x and y, then on; it never ends by itself.
constexpr const char* kLoop = "LOOP\nMOVE(200,200,0)\nMOVE(0,0,0)\nENDLOOP\n";

struct Row {
  double time = 0;
  double x = 0;
  double y = 0;
  double x_speed = 0;
  double x_acceleration = 0;
};

/// Complete rows of a gantry's trace that is perhaps still being written.
std::vector<Row> rows_of(const std::string& trace) {
  std::vector<Row> rows;
  std::ifstream file(trace);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line) && !file.eof()) {
    std::istringstream row(line);
    std::vector<double> values;
    for (std::string field; std::getline(row, field, ',');) values.push_back(std::stod(field));
    if (values.size() > 15)
      rows.push_back({values[0], values[9], values[10], values[12], values[15]});
  }
  return rows;
}

/// Its full speed is 20 mm/s.
void wait_until_it_is_fast(const std::string& trace) {
  wait_for_row(trace, kXSpeed, [](double speed) { return std::abs(speed) > 19.9; });
}

/// The gantry with a hold of 2·√(20/200) s = 0.63 s, so that a second signal comes within it on a
/// busy computer, too: 20 mm/s at 200 mm/s³, which takes √(20·200) mm/s² = 63 mm/s². Paul's law
/// then needs longer corners.
std::string gentle_gantry(const RobCommand& rob) {
  std::string text = read_whole_file(ROB_SOURCE_DIR "/motion/robots/gantry.toml");
  const auto replace = [&](const std::string& what, const std::string& with) {
    const std::size_t at = text.find(what);
    REQUIRE(at != std::string::npos);
    text.replace(at, what.size(), with);
  };
  replace("t_acc = \"1.375 s\"", "t_acc = \"2.75 s\"");
  for (int axis = 0; axis < 2; ++axis) replace("j_max = \"1000 mm/s^3\"", "j_max = \"200 mm/s^3\"");
  std::ofstream(rob.file("gentle.toml")) << text;
  return rob.file("gentle.toml");
}

ProcessResult shell(const std::string& command) {
  return run_process({"/bin/bash", "-c", command});
}

std::string quoted(const std::string& text) { return "'" + text + "'"; }

}  // namespace

TEST_CASE("fault 36: whatever signal would end the process stops the robot on its path first") {
  struct Run {
    explicit Run(int ends_by) : signal(ends_by) {}
    int signal;
    RobCommand rob{kLoop};
    std::string trace = rob.file("t.csv");
    Process process{rob.line("run", {"--json", "--trace", trace})};
  };
  std::vector<std::unique_ptr<Run>> runs;
  for (const int signal : {SIGQUIT, SIGUSR1, SIGUSR2, SIGALRM, SIGVTALRM, SIGPROF, SIGIO, SIGPWR,
                           SIGXCPU, SIGSTKFLT, SIGRTMIN, SIGRTMAX}) {
    runs.push_back(std::make_unique<Run>(signal));
  }
  for (const auto& run : runs) {
    CAPTURE(run->signal);
    wait_until_it_is_fast(run->trace);
    run->process.send(run->signal);
    const ProcessResult result = run->process.wait();
    CHECK(result.exit_code == 128 + run->signal);
    CHECK(json::parse(result.out)["status"] == "interrupted");
    const std::vector<Row> rows = rows_of(run->trace);
    CHECK(rows.back().x == rows.back().y);  // on the diagonal
    CHECK(rows.back().x_speed == 0);
  }
}

TEST_CASE("fault 35: a second Ctrl-C brakes with all that the axes have") {
  const RobCommand rob(kLoop);
  const std::string trace = rob.file("t.csv");
  Process run(rob.line("run", {"--json", "--robot", gentle_gantry(rob), "--trace", trace}));
  wait_until_it_is_fast(trace);
  run.send(SIGINT);
  wait_for_row(trace, kXSpeed, [](double speed) { return std::abs(speed) < 19; });
  CHECK(newest_row(trace)[kXSpeed] != 0);
  run.send(SIGINT);
  CHECK(run.wait().exit_code == 130);
  double most = 0;
  const std::vector<Row> rows = rows_of(trace);
  for (const Row& row : rows) most = std::max(most, std::abs(row.x_acceleration));
  CHECK(most == doctest::Approx(100));  // the gantry's a_max, mm/s²; a hold takes 63 at most
  CHECK(rows.back().x_speed == 0);
}

TEST_CASE("fault 40: a file that may grow no more ends the trace, not the run") {
  const RobCommand rob("MOVE(100,0,0)\nMOVE(0,0,0)\n");
  const ProcessResult result =
      shell("ulimit -f 50; exec " + quoted(ROB_BINARY) + " run --fast " + quoted(rob.program()) +
            " --trace " + quoted(rob.file("t.csv")));
  CHECK(result.exit_code == 74);
  CHECK(contains(result.out, "done: planned 12.75 s"));
  CHECK(contains(result.err, "is incomplete"));
}

TEST_CASE("a run whose reader has gone stops the robot and ends") {
  const RobCommand rob("LOOP\nMOVE(10,0,0)\nPRINT \"there\"\nMOVE(0,0,0)\nENDLOOP\n");
  for (const char* const clock : {"", " --fast"}) {
    CAPTURE(clock);
    const ProcessResult result = shell(quoted(ROB_BINARY) + " run " + quoted(rob.program()) +
                                       clock + " | head -n 1; exit ${PIPESTATUS[0]}");
    CHECK(result.out == "there\n");
    CHECK(result.exit_code == 74);
  }
  // Nor does it need anything to print.
  const RobCommand mute(kLoop);
  CHECK(shell(quoted(ROB_BINARY) + " run " + quoted(mute.program()) +
              " | true; exit ${PIPESTATUS[0]}")
            .exit_code == 74);
}

TEST_CASE("what cannot be written to standard output is an error of every command") {
  const RobCommand rob("PRINT 1\nMOVE(10,0,0)\n");
  for (const std::string& command :
       {std::string("--version"), std::string("--help"), std::string("help MOVE"),
        std::string("robots"), "check " + quoted(rob.program()),
        "check --json " + quoted(rob.program()), "compile --listing " + quoted(rob.program()),
        "run --fast " + quoted(rob.program()), "run --fast --json " + quoted(rob.program())}) {
    for (const char* const lost : {" > /dev/full", " >&-"}) {
      CAPTURE(command);
      CAPTURE(lost);
      const ProcessResult result = shell(quoted(ROB_BINARY) + " " + command + lost);
      CHECK(result.exit_code == 74);
      CHECK(contains(result.err, "could not all be written"));
    }
  }
}

TEST_CASE("standard streams that are closed never become files of the run") {
  const RobCommand rob("PRINT 1\nMOVE(10,0,0)\n");
  const std::string trace = rob.file("t.csv");
  shell(quoted(ROB_BINARY) + " run --fast " + quoted(rob.program()) + " --trace " + quoted(trace) +
        " <&- >&- 2>&-");
  const std::string text = read_whole_file(trace);
  CHECK(text.starts_with("t,line,"));
  CHECK_FALSE(contains(text, "rob:"));
  CHECK_FALSE(contains(text, "done"));
}

#if !defined(ROB_SANITIZED)
// The sanitizers reserve more memory than these limits leave.
TEST_CASE("where no thread can be made nothing moves, and the message says so") {
  const RobCommand rob("MOVE(10,0,0)\nPRINT \"moved\"\n");
  int refused = 0;
  for (int kilobytes = 30'000; kilobytes < 46'000; kilobytes += 1000) {
    const ProcessResult result = shell("ulimit -v " + std::to_string(kilobytes) + "; exec " +
                                       quoted(ROB_BINARY) + " run " + quoted(rob.program()));
    if (!contains(result.err, "a thread cannot be started")) continue;
    ++refused;
    CHECK(result.exit_code == 70);
    CHECK(contains(result.err, "nothing has moved"));
    CHECK(result.out.empty());
    CHECK_FALSE(contains(rob("run", {"--fast"}).err, "unclean end"));
  }
  CHECK(refused > 0);
}
#endif
