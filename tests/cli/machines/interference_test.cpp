// What other people's devices showed: what is done at a machine, adapters and lines that are not as
// they should be. The message names the cause, and where the robot was measured. In real time.
#include <doctest/doctest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <regex>
#include <thread>

#include "tests/emulators/grbl_emulator.h"
#include "tests/emulators/servo_emulator.h"
#include "tests/emulators/tcp_bridge.h"
#include "tests/support/eventually.h"
#include "tests/support/wired_gantry.h"

using rob::test::contains;
using rob::test::eventually;
using rob::test::gantry_file;
using rob::test::GrblEmulator;
using rob::test::kServoWires;
using rob::test::Process;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::ServoEmulator;
using rob::test::TcpBridge;
using Kind = rob::test::ServoEmulator::Kind;
using namespace std::chrono_literals;

namespace {

struct Interfered {
  ProcessResult result;
  double seconds = 0;  ///< from what happened to the end of the process
};

/// 100 mm along x on grbl, into which something happens.
Interfered interfere(GrblEmulator& grbl, const std::function<void()>& happens) {
  const RobCommand rob("MOVE(100,0,0)\n");
  Process process(rob.line("run", {"--backend", "grbl:" + grbl.path()}));
  REQUIRE(eventually([&] { return grbl.moves() >= 50; }));
  happens();
  const auto since = std::chrono::steady_clock::now();
  Interfered ended;
  ended.result = process.wait();
  ended.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
  return ended;
}

/// The same on servos, 20.48 ticks a mm.
Interfered interfere(const std::string& kind, ServoEmulator& bus,
                     const std::function<void()>& happens) {
  bus.stand_at(3, 2048 + 50 * 20.48);
  const RobCommand rob("MOVE(110,0,0)\n");
  const std::string file = gantry_file(rob, kServoWires);
  Process process(rob.line("run", {"--robot", file, "--backend", kind + ":" + bus.path()}));
  REQUIRE(eventually([&] { return bus.moved_for() >= 1.5; }));
  happens();
  return {process.wait(), 0};
}

/// "the robot stands at x 23.66 mm …": of x.
double told_place(const std::string& text) {
  std::smatch found;
  REQUIRE_MESSAGE(
      std::regex_search(text, found, std::regex("the robot stands at x (-?[0-9.]+) mm")), text);
  return std::stod(found[1]);
}

}  // namespace

TEST_CASE("what is done at grbl ends the run with its name, and the measured position") {
  struct Case {
    const char* words;
    void (*happens)(GrblEmulator& grbl);
  };
  const Case cases[] = {
      {"put on hold at the machine", [](GrblEmulator& grbl) { grbl.hold(); }},
      {"its safety door is open", [](GrblEmulator& grbl) { grbl.open_door(); }},
      {"the feed override of grbl is at 50 %", [](GrblEmulator& grbl) { grbl.override_feed(50); }},
      {"it is jogged", [](GrblEmulator& grbl) { grbl.take_foreign("$J=G91 G21 Y5 F600"); }},
      {"answers of grbl were lost", [](GrblEmulator& grbl) { grbl.lost_oks = 1000; }}};
  for (const Case& made : cases) {
    GrblEmulator grbl;
    const Interfered ended = interfere(grbl, [&] { made.happens(grbl); });
    CAPTURE(ended.result.err);
    CHECK(ended.result.exit_code == 70);
    CHECK(contains(ended.result.err, made.words));
    CHECK_FALSE(contains(ended.result.err, "what blocks the axis"));
    CHECK_FALSE(contains(ended.result.err, "check the encoder"));
    CHECK(std::abs(told_place(ended.result.err) - grbl.position()[0]) < 0.02);
  }
}

TEST_CASE("fault 26: after grbl has fallen silent the process ends when the axes stand") {
  GrblEmulator grbl;
  const Interfered ended = interfere(grbl, [&] { grbl.silent = true; });
  CHECK(ended.result.exit_code == 70);
  CHECK(contains(ended.result.err, "does not answer"));
  // 0.5 s until it counts as silent, 0.4 s to brake, 0.3 s to be left.
  CHECK(ended.seconds < 2.5);
  CHECK(eventually([&] { return grbl.idle(); }));
}

TEST_CASE("a servo that is blocked: where it was measured, and where its reference is") {
  ServoEmulator bus(Kind::Feetech, 3);
  const Interfered ended = interfere("feetech", bus, [&] { bus.blocked = 3; });
  CAPTURE(ended.result.err);
  CHECK(ended.result.exit_code == 70);
  const double stands = 60 - (bus.position(3) - 2048) / 20.48;
  CHECK(std::abs(told_place(ended.result.err) - stands) < 0.02);
  CHECK(contains(ended.result.err, " mm (its reference is "));
}

TEST_CASE("fault 31: a servo that restarts in motion is said to have restarted") {
  for (const auto kind : {Kind::Dynamixel, Kind::Feetech}) {
    ServoEmulator bus(kind, 3);
    const std::string name = kind == Kind::Dynamixel ? "dynamixel" : "feetech";
    const Interfered ended = interfere(name, bus, [&] { bus.restart(3); });
    CAPTURE(ended.result.err);
    CHECK(ended.result.exit_code == 70);
    CHECK(contains(ended.result.err, "error[E510]"));
    CHECK(contains(ended.result.err, "servo 3 (axis x) has restarted"));
  }
}

TEST_CASE("six DYNAMIXEL servos at 57,600 baud: the cycle is what fits, and that is said") {
  ServoEmulator bus(Kind::Dynamixel, 6);
  bus.baud = 57600;
  const RobCommand rob("MOVE JOINTS(20deg, 10deg, -10deg, 30deg, 0deg, 30deg)\nSTOP\n");
  std::string text = rob::test::read_whole_file(ROB_SOURCE_DIR "/motion/robots/so101.toml");
  text += "\n[wire]\nbaud = 57600\n";
  std::ofstream(rob.file("slow.toml")) << text;
  const ProcessResult result =
      rob("run", {"--robot", rob.file("slow.toml"), "--backend", "dynamixel:" + bus.path()});
  CAPTURE(result.err);
  CHECK(result.exit_code == 0);
  CHECK(contains(result.err, "a cycle of this machine takes 50 ms, not 10 ms"));
  CHECK(contains(result.err, "6 axes at 57600 baud"));
  const double end[] = {20, 10, -10, 30, 0, 30};
  for (int id = 1; id <= 6; ++id)
    CHECK(std::abs(bus.position(id) - (2048 + end[id - 1] * 4096 / 360)) < 1);
}

TEST_CASE("an adapter that echoes is used as any other") {
  ServoEmulator bus(Kind::Feetech, 3);
  bus.echoes = true;
  bus.stand_at(3, 2048 + 50 * 20.48);
  const RobCommand rob("MOVE(20,0,0)\nSTOP\n");
  const std::string file = gantry_file(rob, kServoWires);
  const ProcessResult result = rob("run", {"--robot", file, "--backend", "feetech:" + bus.path()});
  CAPTURE(result.err);
  CHECK(result.exit_code == 0);
  CHECK(std::abs(bus.position(3) - (2048 + 40 * 20.48)) < 1);
}

TEST_CASE("a run begins where grblHAL stands, though its first report leaves the offset out") {
  GrblEmulator grbl;
  grbl.banner = "GrblHAL 1.1f ['$' or '$HELP' for help]";
  grbl.offset_in_report = 2;
  grbl.offset = {-100, -80, 0};
  const RobCommand rob("MOVE(110,80,0)\nSTOP\n");
  const ProcessResult result = rob("run", {"--backend", "grbl:" + grbl.path()});
  CAPTURE(result.err);
  CHECK(result.exit_code == 0);
  CHECK(grbl.position()[0] == doctest::Approx(10).epsilon(0.001));
  CHECK(std::abs(grbl.position()[1]) < 0.005);
}

TEST_CASE("a machine behind a network connection is a machine like any other") {
  GrblEmulator grbl;
  TcpBridge bridge(grbl.path());
  const RobCommand rob("MOVE(10,0,0)\nSTOP\n");
  const ProcessResult result = rob("run", {"--backend", "grbl:" + bridge.address()});
  CAPTURE(result.err);
  CHECK(result.exit_code == 0);
  CHECK(grbl.position()[0] == doctest::Approx(10).epsilon(0.001));
  CHECK(bridge.connections() == 1);
  const ProcessResult none = rob("run", {"--backend", "rob:tcp://127.0.0.1"});
  CHECK(none.exit_code == 74);
  CHECK(contains(none.err, "is no network address; write tcp://host:port"));
}
