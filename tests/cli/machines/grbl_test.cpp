// `rob run --backend …` on devices behind pseudo-terminals: the same programs as on the simulation,
// and what happens when a wire fails in motion. In real time, with bounds for a busy computer.
#include <doctest/doctest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "tests/emulators/grbl_emulator.h"
#include "tests/support/eventually.h"
#include "tests/support/rob_command.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::eventually;
using rob::test::GrblEmulator;
using rob::test::Process;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using namespace std::chrono_literals;

namespace {

constexpr const char* kTriangle =
    "MOVE(40,40,0)\nMOVE(140,40,0)\nMOVE(90,126,0)\nMOVE(40,40,0)\nSTOP\nEND\n";
constexpr const char* kLong = "MOVE(300,0,0)\n";

std::string on(const std::string& kind, rob::test::DeviceEmulator& device) {
  return kind + ":" + device.path();
}

/// Waits until the device has been spoken to that often.
void wait_for_motion(const GrblEmulator& grbl) {
  REQUIRE(eventually([&] { return grbl.moves() >= 50; }));
}

struct Faulted {
  json document;
  ProcessResult result;
};

/// A long run on grbl, into which something happens.
template <typename Happens>
Faulted run_into(const Happens& happens) {
  GrblEmulator grbl;
  const RobCommand rob(kLong);
  Process process(rob.line("run", {"--json", "--backend", on("grbl", grbl)}));
  wait_for_motion(grbl);
  happens(grbl);
  const auto since = std::chrono::steady_clock::now();
  Faulted faulted;
  faulted.result = process.wait();
  CHECK(std::chrono::steady_clock::now() - since < 10s);
  faulted.document = json::parse(faulted.result.out);
  return faulted;
}

void check_fault(const Faulted& faulted, const std::string& code, const std::string& words) {
  CHECK(faulted.result.exit_code == 70);
  CHECK(faulted.document["status"] == "fault");
  CHECK(faulted.document["error"]["code"] == code);
  CHECK(contains(faulted.document["error"]["message"], words));
  CHECK_FALSE(faulted.document["events"].empty());
}

}  // namespace

TEST_CASE("the triangle through grbl: executed within 1 % of what is planned") {
  GrblEmulator grbl;
  const RobCommand rob(kTriangle);
  const ProcessResult result = rob("run", {"--json", "--backend", on("grbl", grbl)});
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  const json document = json::parse(result.out);
  CHECK(document["planned_s"].get<double>() == doctest::Approx(19.1));
  CHECK(grbl.moved_for() == doctest::Approx(19.1).epsilon(0.01));
  CHECK(grbl.overflows() == 0);
  const auto q = grbl.position();
  CHECK(q[0] == doctest::Approx(40).epsilon(0.001));
  CHECK(q[1] == doctest::Approx(40).epsilon(0.001));
  CHECK(grbl.idle());
}

TEST_CASE("a run begins where the machine stands") {
  GrblEmulator grbl;
  grbl.stand_at(130, 0, 0);
  const RobCommand rob("MOVE(140,0,0)\nSTOP\n");
  const ProcessResult result = rob("run", {"--json", "--backend", on("grbl", grbl)});
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  CHECK(grbl.position()[0] == doctest::Approx(140).epsilon(0.001));
  // From 0 it would be 7 s, and half a corner at each end.
  CHECK(json::parse(result.out)["planned_s"].get<double>() == doctest::Approx(5.5));
}

TEST_CASE("a program that counts on signals is told that the wire carries none") {
  GrblEmulator grbl;
  const auto told = [&](const std::string& program) {
    const ProcessResult result = RobCommand(program)("check", {"--backend", on("grbl", grbl)});
    CHECK(result.exit_code == 0);
    return result.err;
  };
  const std::string words = "the wire of this machine carries no signals";
  CHECK(contains(told("MOVE(10,0,0)\nDOUT[3] = ON\n"), ".rob:2: " + words));
  CHECK(contains(told("MOVE(10,0,0)\nPULSE DOUT[3] 50ms\n"), ".rob:2: " + words));
  CHECK(contains(told("IF DIN[3] THEN MOVE(10,0,0)\n"), ".rob:1: " + words));
  CHECK(contains(told("MOVE(10,0,0) UNTIL DIN[3]\n"), ".rob:1: " + words));
  CHECK_FALSE(contains(told("MOVE(10,0,0)\nPRINT 1\n"), words));
}

TEST_CASE("check takes the machine's limits, and moves nothing") {
  GrblEmulator grbl;
  for (int axis = 0; axis < 3; ++axis) grbl.settings[110 + axis] = 600;  // 10 mm/s
  const RobCommand rob("MOVE(100,0,0)\nSTOP\n");
  const ProcessResult result = rob("check", {"--json", "--backend", on("grbl", grbl)});
  CHECK(result.exit_code == 0);
  CHECK(contains(result.err, "no more than 10 mm of speed (per s) of axis x"));
  // 100 mm at 10 mm/s, and half a corner at each end.
  CHECK(json::parse(result.out)["planned_s"].get<double>() == doctest::Approx(10 + 2 * 1.375));
  CHECK(grbl.moves() == 0);
}

TEST_CASE("fault 23: unplugged in motion") {
  check_fault(run_into([](GrblEmulator& grbl) { grbl.unplug(); }), "E507", "is gone");
}

TEST_CASE("fault 30: a limit switch in motion") {
  const Faulted faulted = run_into([](GrblEmulator& grbl) { grbl.raise_alarm(1); });
  check_fault(faulted, "E510", "grbl ALARM:1: a limit switch was hit");
  CHECK(contains(faulted.document["error"]["message"].get<std::string>() +
                     faulted.document["error"]["help"].get<std::string>(),
                 "position is not known"));
}

TEST_CASE("fault 26: silence in motion") {
  check_fault(run_into([](GrblEmulator& grbl) { grbl.silent = true; }), "E506", "does not answer");
}

TEST_CASE("faults 35, 36: a stop while the machine homes itself") {
  struct Request {
    int signal;
    int exit_code;
  };
  for (const Request& request : {Request{SIGINT, 130}, Request{SIGTERM, 143}}) {
    GrblEmulator grbl;
    grbl.homes_on = true;
    const RobCommand rob(kLong);
    Process process(rob.line("run", {"--home", "--backend", on("grbl", grbl)}));
    REQUIRE(eventually([&] { return grbl.homing() > 0; }));
    const int resets = grbl.resets();
    process.send(request.signal);
    const ProcessResult result = process.wait();
    CHECK(result.exit_code == request.exit_code);
    CHECK(contains(result.err, "homing was given up: the machine has stopped"));
    CHECK(eventually([&] { return grbl.resets() == resets + 1; }));
    CHECK(grbl.moves() == 0);
  }
}

TEST_CASE("fault 31: a restart in motion") {
  check_fault(run_into([](GrblEmulator& grbl) { grbl.restart(); }), "E510", "has restarted");
}

TEST_CASE("fault 33: a second rob on the same port is refused, and the first goes on") {
  GrblEmulator grbl;
  const RobCommand rob(kLong);
  Process first(rob.line("run", {"--backend", on("grbl", grbl)}));
  wait_for_motion(grbl);
  const ProcessResult second = rob("run", {"--backend", on("grbl", grbl)});
  CHECK(second.exit_code == 74);
  CHECK(contains(second.err, "is used by process"));
  CHECK(contains(second.err, "(rob)"));
  const int moves = grbl.moves();
  CHECK(eventually([&] { return grbl.moves() > moves; }));
  first.send(SIGINT);
  CHECK(first.wait().exit_code == 130);
  CHECK(eventually([&] { return grbl.idle(); }));
}

TEST_CASE("fault 32: a machine that stands outside of the limits is not enabled") {
  GrblEmulator grbl;
  grbl.stand_at(-20, 0, 0);
  const ProcessResult result = RobCommand(kLong)("run", {"--backend", on("grbl", grbl)});
  CHECK(result.exit_code == 74);
  CHECK(contains(result.err, "axis x stands at -20 mm, outside of 0 mm"));
  CHECK(grbl.moves() == 0);
}

TEST_CASE("fault 32: at the prompt an axis outside of its limits can go back alone, slowly") {
  const auto jogged = [](const std::string& jog, std::string& told) {
    GrblEmulator grbl;
    grbl.stand_at(-20, 0, 0);
    const RobCommand rob("");
    const ProcessResult result =
        rob::test::run_process({"/bin/bash", "-c",
                                "cd " + rob.file("") + " && echo '" + jog + "' | " + ROB_BINARY +
                                    " --backend " + on("grbl", grbl)});
    told = result.err + result.out;
    CHECK(eventually([&] { return grbl.idle(); }));
    return grbl.position()[0];
  };
  std::string told;
  CHECK(jogged("JOG JOINT (-20mm/s, 0mm/s, 0deg/s) FOR 2s", told) == doctest::Approx(-20));
  CHECK(contains(told, "axis x stands at -20 mm, outside of 0 mm"));
  CHECK(contains(told, "it can go back only"));
  // A tenth of 20 mm/s for 2 s.
  const double back = jogged("JOG JOINT (20mm/s, 0mm/s, 0deg/s) FOR 2s", told);
  CAPTURE(told);
  CHECK(back > -18);
  CHECK(back <= -16 + 0.1);
}

TEST_CASE("a jog over grbl stands in time: its own braking, and what grbl has ahead") {
  GrblEmulator grbl;
  const RobCommand rob("JOG JOINT (20mm/s, 0mm/s, 0deg/s) FOR 500ms\n");
  const ProcessResult result = rob("run", {"--json", "--backend", on("grbl", grbl)});
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  // 20 mm/s takes 0.2 s + 0.1 s at 100 mm/s² and 1000 mm/s³, and as long at the end.
  CHECK(grbl.moved_for() > 0.4);
  CHECK(grbl.moved_for() < 0.5 + 0.3 + 0.08 + 0.1);
  CHECK(grbl.position()[0] > 5);
  CHECK(grbl.position()[0] < 20 * (0.5 + 0.15) + 0.1);
  CHECK(grbl.idle());
}

TEST_CASE("fault 18: grbl whose axes do not go where its motors turn") {
  const Faulted faulted = run_into([](GrblEmulator& grbl) { grbl.jammed = true; });
  CHECK(faulted.result.exit_code == 70);
  const std::string code = faulted.document["error"]["code"];
  CHECK((code == "E502" || code == "E503"));
}

TEST_CASE("grbl does not see where a hand brings it: :guide is refused") {
  GrblEmulator grbl;
  const RobCommand rob("");
  const ProcessResult result = rob::test::run_process(
      {"/bin/bash", "-c",
       "cd " + rob.file("") + " && (echo ':guide on'; echo 'MOVE(10,0,0)') | " + ROB_BINARY +
           " --backend " + on("grbl", grbl)});
  CHECK(contains(result.err, "where a hand brings it is not seen"));
  CHECK(contains(result.err, ":jog brings it"));
}

TEST_CASE("what --backend cannot be is told") {
  const RobCommand rob(kLong);
  CHECK(rob("run", {"--backend", "grbl"}).exit_code == 64);
  CHECK(contains(rob("run", {"--backend", "fanuc:/dev/x"}).err,
                 "there is no backend 'fanuc:/dev/x'"));
  CHECK(rob("run", {"--backend", "grbl:/dev/ttyNothing", "--fast"}).exit_code == 64);
  const ProcessResult missing = rob("run", {"--backend", "grbl:/dev/ttyNothing"});
  CHECK(missing.exit_code == 74);
  CHECK(contains(missing.err, "there is no port '/dev/ttyNothing'"));
  GrblEmulator grbl;
  CHECK(contains(rob("run", {"--backend", on("dynamixel", grbl)}).err, "travel = "));
}
