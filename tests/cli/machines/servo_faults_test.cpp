// Faults of a run on servos, by their row of docs/faults.md: message, exit code, report, and drives
// without force. In real time.
#include <doctest/doctest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "tests/emulators/servo_emulator.h"
#include "tests/support/eventually.h"
#include "tests/support/wired_gantry.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::gantry_file;
using rob::test::kServoWires;
using rob::test::Process;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::ServoEmulator;
using Kind = rob::test::ServoEmulator::Kind;
using namespace std::chrono_literals;

namespace {

struct Ended {
  int exit_code = 0;
  json report;
};

/// 100 mm along x at 20 mm/s, into which something happens as soon as it is 1.5 s under way.
Ended run_into(const std::string& kind, ServoEmulator& bus, const std::function<void()>& happens) {
  bus.stand_at(3, 2048 + 50 * 20.48);
  const RobCommand rob("MOVE(110,0,0)\n");
  const std::string file = gantry_file(rob, kServoWires);
  Process process(
      rob.line("run", {"--json", "--robot", file, "--backend", kind + ":" + bus.path()}));
  REQUIRE(rob::test::eventually([&] { return bus.moved_for() >= 1.5; }));
  happens();
  const auto since = std::chrono::steady_clock::now();
  const ProcessResult result = process.wait();
  CHECK(std::chrono::steady_clock::now() - since < 20s);
  for (const int id : {1, 2, 3})  // the safe state
    CHECK(rob::test::eventually([&] { return !bus.torque(id); }));
  return {result.exit_code, json::parse(result.out)};
}

void check_fault(const Ended& ended, const std::string& code, const std::string& words) {
  const json& error = ended.report["error"];
  CAPTURE(error.dump());
  CHECK(ended.exit_code == 70);
  CHECK(ended.report["status"] == "fault");
  CHECK(error["code"] == code);
  CHECK(contains(error["message"], words));
  // The entry of the log, with its time.
  CHECK(contains(ended.report["events"].dump(), error["message"]));
  CHECK(ended.report["measured_s"].get<double>() < 7.5);  // not to its end
}

}  // namespace

TEST_CASE("fault 18: servos that are slower than their references") {
  ServoEmulator bus(Kind::Feetech, 3);
  const Ended ended = run_into("feetech", bus, [&] { bus.speed = 100; });
  check_fault(ended, "E502", "x");
  CHECK(bus.position(3) > 2048 - 50 * 20.48 + 100);  // it has not arrived
}

TEST_CASE("fault 19: an encoder that freezes") {
  ServoEmulator bus(Kind::Dynamixel, 3);
  check_fault(run_into("dynamixel", bus, [&] { bus.frozen = true; }), "E503", "x");
}

TEST_CASE("fault 19: an encoder that jumps, and stays there") {
  ServoEmulator bus(Kind::Feetech, 3);
  check_fault(run_into("feetech", bus, [&] { bus.jumped = 600; }), "E504", "x");
}

TEST_CASE("fault 25: nothing but wrong checks") {
  ServoEmulator bus(Kind::Dynamixel, 3);
  check_fault(run_into("dynamixel", bus, [&] { bus.corrupt = 100; }), "E506", "answer");
}

TEST_CASE("fault 25: one answer of ten has a wrong check: it arrives, with a warning") {
  ServoEmulator bus(Kind::Dynamixel, 3);
  const Ended ended = run_into("dynamixel", bus, [&] { bus.corrupt = 10; });
  CAPTURE(ended.report["error"].dump());
  CHECK(ended.exit_code == 0);
  CHECK(contains(ended.report["events"].dump(), "\"warning\""));
  CHECK(contains(ended.report["events"].dump(), "goes over the wire of the machine is repeated"));
  CHECK(contains(ended.report["findings"].dump(), "W647"));
  CHECK(std::abs(bus.position(3) - (2048 - 50 * 20.48)) < 1);
}
