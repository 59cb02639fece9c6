// Row 38 of docs/faults.md on machines: the whole process is stopped in motion and goes on. In real
// time.
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <functional>
#include <thread>

#include "tests/emulators/device_process.h"
#include "tests/emulators/grbl_emulator.h"
#include "tests/emulators/servo_emulator.h"
#include "tests/support/eventually.h"
#include "tests/support/trace_file.h"
#include "tests/support/trace_rows.h"
#include "tests/support/wired_gantry.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::DeviceProcess;
using rob::test::eventually;
using rob::test::gantry_file;
using rob::test::GrblEmulator;
using rob::test::kMeasuredX;
using rob::test::kServoWires;
using rob::test::Process;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::ServoEmulator;
using rob::test::wait_for_row;
using namespace std::chrono_literals;

namespace {

struct Stopped {
  double stood = 0;  ///< where the machine had come to rest by itself
  double ended = 0;  ///< where it stands after the run
};

/// Runs 100 mm along x from 10 mm on, stops the process as soon as it `moves`, for a second or
/// until the machine stands, and lets it go on.
Stopped stop_and_go_on(const std::vector<std::string>& line, const std::function<bool()>& moves,
                       const std::function<double()>& place) {
  Process process(line);
  REQUIRE(eventually(moves));
  process.send(SIGSTOP);
  Stopped stopped;
  std::this_thread::sleep_for(800ms);
  CHECK(eventually([&] {
    stopped.stood = place();
    std::this_thread::sleep_for(200ms);
    return std::abs(place() - stopped.stood) < 1e-6;
  }));
  process.send(SIGCONT);
  const ProcessResult result = process.wait();
  stopped.ended = place();
  CAPTURE(result.err);
  CHECK(result.exit_code == 70);
  const json report = json::parse(result.out);
  CHECK(report["error"]["code"] == "E501");
  CHECK(contains(report["error"]["message"], " ms late"));
  return stopped;
}

}  // namespace

TEST_CASE("fault 38: grbl that stands after a stopped process is not driven on") {
  GrblEmulator grbl;
  grbl.stand_at(10, 0, 0);
  const RobCommand rob("MOVE(110,0,0)\n");
  const Stopped stopped = stop_and_go_on(
      rob.line("run", {"--json", "--backend", "grbl:" + grbl.path()}),
      [&] { return grbl.position()[0] > 20; }, [&] { return grbl.position()[0]; });
  CHECK(std::abs(stopped.ended - stopped.stood) < 0.01);  // two steps
  CHECK(grbl.idle());
}

TEST_CASE("fault 38: servos that stand after a stopped process are not driven on") {
  for (const auto kind : {ServoEmulator::Kind::Dynamixel, ServoEmulator::Kind::Feetech}) {
    const bool dynamixel = kind == ServoEmulator::Kind::Dynamixel;
    CAPTURE(dynamixel);
    ServoEmulator bus(kind, 3);
    bus.stand_at(3, 2048 + 50 * 20.48);
    const RobCommand rob("MOVE(110,0,0)\n");
    const std::string file = gantry_file(rob, kServoWires);
    const Stopped stopped = stop_and_go_on(
        rob.line("run", {"--json", "--robot", file, "--backend",
                         (dynamixel ? "dynamixel:" : "feetech:") + bus.path()}),
        [&] { return bus.moved_for() > 1; }, [&] { return bus.position(3); });
    CHECK(std::abs(stopped.ended - stopped.stood) <= 1);  // a tick
    CHECK(eventually([&] { return !bus.torque(3); }));
  }
}

TEST_CASE("fault 19: servos that make up what a late computer owes them do not jump") {
  for (const auto kind : {ServoEmulator::Kind::Dynamixel, ServoEmulator::Kind::Feetech}) {
    const bool dynamixel = kind == ServoEmulator::Kind::Dynamixel;
    CAPTURE(dynamixel);
    ServoEmulator bus(kind, 3);
    bus.speed = 40000;  // 98 times the axis' own limit
    bus.stand_at(3, 2048 + 50 * 20.48);
    const RobCommand rob("MOVE(110,0,0)\n");
    const std::string file = gantry_file(rob, kServoWires);
    Process process(rob.line("run", {"--json", "--robot", file, "--backend",
                                     (dynamixel ? "dynamixel:" : "feetech:") + bus.path()}));
    REQUIRE(eventually([&] { return bus.moved_for() > 1; }));
    for (int pause = 0; pause < 20; ++pause) {
      process.send(SIGSTOP);
      std::this_thread::sleep_for(std::chrono::milliseconds(20 + 5 * (pause % 10)));
      process.send(SIGCONT);
      std::this_thread::sleep_for(100ms);
    }
    const ProcessResult result = process.wait();
    CAPTURE(result.out);
    const json report = json::parse(result.out);
    const bool late = report["error"].is_object() && report["error"]["code"] == "E501";
    CHECK((late || result.exit_code == 0));  // the computer itself may be later than that
    if (!late) CHECK(std::abs(bus.position(3) - (2048 - 50 * 20.48)) <= 1);
  }
}

TEST_CASE("fault 38: a device of Rob's own protocol that has braked itself is not driven on") {
  DeviceProcess device(3);
  const RobCommand rob("MOVE(110,0,0)\n");
  const std::string file = gantry_file(rob, {"offset = \"10 mm\"", "offset = \"0 mm\"", ""},
                                       "baud = 1000000\nperiod = \"50 ms\"\n");
  const auto begun = std::chrono::steady_clock::now();
  const std::string trace = rob.file("t.csv");
  Process process(rob.line(
      "run", {"--json", "--robot", file, "--trace", trace, "--backend", "rob:" + device.path()}));
  wait_for_row(trace, kMeasuredX, [](double x) { return x > 12; });
  process.send(SIGSTOP);
  const std::chrono::duration<double> moved = std::chrono::steady_clock::now() - begun;
  std::this_thread::sleep_for(2s);
  process.send(SIGCONT);
  const ProcessResult result = process.wait();
  const DeviceProcess::End end = device.finish();
  CAPTURE(result.err);
  CHECK(result.exit_code == 70);
  const json report = json::parse(result.out);
  CHECK(report["error"]["code"] == "E501");
  CHECK(end.places[0] > 1);
  // Its watchdog stops it 0.15 s after the last reference, within 2 ms; afterwards nothing moves.
  CHECK(end.moved_for < moved.count() + 0.5);
  CHECK(report["final"]["joints"][0] == doctest::Approx(10 + end.places[0]).epsilon(1e-4));
}

TEST_CASE("fault 38: the simulation stands where its drives have braked, to the end of the run") {
  const RobCommand rob("MOVE(110,0,0)\n");
  const std::string trace = rob.file("t.csv");
  Process process(rob.line("run", {"--json", "--trace", trace}));
  wait_for_row(trace, kMeasuredX, [](double x) { return x > 20; });
  process.send(SIGSTOP);
  std::this_thread::sleep_for(1s);
  process.send(SIGCONT);
  const ProcessResult result = process.wait();
  CHECK(result.exit_code == 70);
  const rob::test::TraceFile file = rob::test::parse_trace(rob::test::read_whole_file(trace));
  std::vector<double> stands;
  double before = 0;
  for (const rob::test::TraceRow& row : file.rows) {
    if (row.t - before > 0.5 || !stands.empty()) stands.push_back(row.measured[0]);
    before = row.t;
  }
  REQUIRE_FALSE(stands.empty());
  const auto [least, most] = std::minmax_element(stands.begin(), stands.end());
  CHECK(*most - *least < 0.02);
  CHECK(std::abs(file.rows.back().q[0] - stands.back()) < 0.02);
}
