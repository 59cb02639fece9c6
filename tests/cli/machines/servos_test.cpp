// `rob run --backend …` on servos and on a device of Rob's own protocol: the same program as on the
// simulation, what the robot file says of the wire, and what happens when it goes wrong. In real
// time, with bounds for a busy computer.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/emulators/device_process.h"
#include "tests/emulators/servo_emulator.h"
#include "tests/support/eventually.h"
#include "tests/support/wired_gantry.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::DeviceProcess;
using rob::test::eventually;
using rob::test::gantry_file;
using rob::test::kScsWires;
using rob::test::kServoWires;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::ServoEmulator;
using Kind = rob::test::ServoEmulator::Kind;

namespace {

/// From (10, 10, 0): under Paul's law each leg of 40 mm takes 2·t_acc = 2.75 s, and so do both ends
/// together.
constexpr const char* kThere = "MOVE(50,30,15)\nMOVE(90,10,-15)\nSTOP\n";

std::string on(const std::string& kind, ServoEmulator& bus) { return kind + ":" + bus.path(); }

/// Stands at (10, 10, 0): a run begins there.
void stand(ServoEmulator& bus, Kind kind) {
  const bool scs = kind == Kind::FeetechScs;
  bus.stand_at(3, scs ? 512 + 50 * 10.24 : 2048 + 50 * 20.48);
  bus.stand_at(1, scs ? 512 - 40 * 5.12 : 2048 + 10 * 10.24);
}

double planned(const ProcessResult& result) {
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  return json::parse(result.out)["planned_s"].get<double>();
}

}  // namespace

TEST_CASE("a prompt on a machine: guided by hand, a point is taught, and driven to") {
  ServoEmulator bus(Kind::Feetech, 3);
  stand(bus, Kind::Feetech);
  const RobCommand rob("");
  // The operator goes on typing when the hand has pushed.
  const std::string typed =
      "(echo ':guide on'; until [ -e pushed ]; do sleep 0.05; done; echo ':teach pick';"
      " echo 'MOVE(10,10,0)'; echo ':guide off'; echo 'MOVE(60,10,0)'; echo 'MOVE pick') | ";
  rob::test::Process process({"/bin/bash", "-c",
                              "cd " + rob.file("") + " && " + typed + ROB_BINARY +
                                  " --keep-going --robot " + gantry_file(rob, kServoWires) +
                                  " --backend " + on("feetech", bus)});
  const std::string without_force = "the drives are without force: hold what could sink";
  REQUIRE(eventually([&] { return contains(process.err_so_far(), without_force); }));
  // A hand pushes it to x = 60 − 256/20.48, y = 320/10.24, mm.
  bus.stand_at(3, 2048 + 256);
  bus.stand_at(1, 2048 + 320);
  const int before = bus.questions();
  REQUIRE(
      eventually([&] { return bus.questions() > before + 3 * 25; }));  // half a second of cycles
  std::ofstream(rob.file("pushed")) << "";
  const ProcessResult result = process.wait();
  CAPTURE(result.err);
  CHECK(contains(result.err, without_force));
  CHECK(contains(result.err, ":guide off takes the robot under control again"));
  const std::string points = rob::test::read_whole_file(rob.file("prompt.gantry.points"));
  CHECK(contains(points, "pick"));
  CHECK(contains(points, "47.5"));
  CHECK(contains(points, "31.25"));
  CHECK(std::abs(bus.position(3) - (2048 + 256)) < 1);
  CHECK(std::abs(bus.position(1) - (2048 + 320)) < 1);
  CHECK(bus.moved_for() > 1);
}

TEST_CASE("the same program on three kinds of servos: executed within 1 % of what is planned") {
  struct Case {
    Kind kind;
    const char* name;
    const std::array<std::string, 3>* wires;
    double ticks_per_mm;          // of x
    std::array<double, 3> ticks;  // of IDs 3, 1, 2 at (90, 10, −15)
  };
  // x: 2048 − (90 − 60)·20.48; y: 2048 + 10·10.24; theta: 2048 − 15·4096/120. Likewise SCS.
  const Case cases[] = {
      {Kind::Dynamixel, "dynamixel", &kServoWires, 20.48, {1433.6, 2150.4, 1536}},
      {Kind::Feetech, "feetech", &kServoWires, 20.48, {1433.6, 2150.4, 1536}},
      {Kind::FeetechScs, "feetech-scs", &kScsWires, 10.24, {204.8, 307.2, 460.8}},
  };
  for (const Case& made : cases) {
    CAPTURE(made.name);
    ServoEmulator bus(made.kind, 3);
    stand(bus, made.kind);
    const RobCommand rob(kThere);
    const std::string file = gantry_file(rob, *made.wires);
    const double duration =
        planned(rob("run", {"--json", "--robot", file, "--backend", on(made.name, bus)}));
    CHECK(duration == doctest::Approx(8.25));
    // From the first tick to the last. A corner from rest to v within T = 2.75 s is v·t³/T² off its
    // beginning (Paul's law, t << T): half a tick of x at 40 mm in 2.75 s.
    const double tick = 1 / made.ticks_per_mm;
    const double unseen = std::cbrt(tick / 2 * 2.75 * 2.75 / (40 / 2.75));
    CHECK(bus.moved_for() > 0.99 * duration - 2 * unseen);
    CHECK(bus.moved_for() < 1.01 * duration);
    CHECK(std::abs(bus.position(3) - made.ticks[0]) < 1);
    CHECK(std::abs(bus.position(1) - made.ticks[1]) < 1);
    CHECK(std::abs(bus.position(2) - made.ticks[2]) < 1);
    for (const int id : {1, 2, 3}) CHECK(eventually([&] { return !bus.torque(id); }));
  }
}

TEST_CASE("the same program on a device of Rob's own protocol") {
  DeviceProcess device(3);
  const RobCommand rob(kThere);
  // It stands at its zero: x counts back from 10 mm, y from −(−10) mm on, theta from 0.
  const std::string file =
      gantry_file(rob, {"offset = \"10 mm\"\ndirection = -1", "offset = \"10 mm\"", ""},
                  "baud = 1000000\nperiod = \"20 ms\"\n");
  const double duration =
      planned(rob("run", {"--json", "--robot", file, "--backend", "rob:" + device.path()}));
  CHECK(duration == doctest::Approx(8.25));
  const DeviceProcess::End end = device.finish();
  // Its references are 1e-6 mm: all but what is below that a second is motion.
  CHECK(end.moved_for == doctest::Approx(duration).epsilon(0.01));
  CHECK(end.places[0] == doctest::Approx(-80).epsilon(1e-6));
  CHECK(end.places[1] == doctest::Approx(0).epsilon(1e-6));
  CHECK(end.places[2] == doctest::Approx(-15).epsilon(1e-6));
}

TEST_CASE("period and baud of [wire] are those of the bus") {
  // Within 2 s of standing: a cycle of 50 ms asks three servos 40 times, one of 10 ms 200 times.
  for (const bool slow : {false, true}) {
    ServoEmulator bus(Kind::Dynamixel, 3);
    stand(bus, Kind::Dynamixel);
    const RobCommand rob("WAIT 2s\n");
    const std::string file =
        gantry_file(rob, kServoWires, slow ? "baud = 57600\nperiod = \"50 ms\"\n" : "");
    planned(rob("run", {"--json", "--robot", file, "--backend", on("dynamixel", bus)}));
    CHECK(bus.questions() > (slow ? 100 : 3 * 120));
    CHECK(bus.questions() < (slow ? 3 * 60 : 3 * 400));
  }
}

TEST_CASE("what [wire] cannot be is refused, with its line") {
  const auto refusal = [](const std::string& x, const std::string& whole = "") {
    const RobCommand rob(kThere);
    const std::string file = gantry_file(rob, {x, "travel = \"400 mm\"", ""}, whole);
    const ProcessResult result = rob("check", {"--robot", file});
    CHECK(result.exit_code == 65);
    CHECK(contains(result.err, "wired.toml:"));
    return result.err;
  };
  CHECK(contains(refusal("id = 253"), "id"));
  CHECK(contains(refusal("letter = \"Q\""), "letter"));
  CHECK(contains(refusal("travel = \"360 deg\""), "travel"));
  CHECK(contains(refusal("travel = \"0 mm\""), "travel"));
  CHECK(contains(refusal("offset = \"90 deg\""), "offset"));
  CHECK(contains(refusal("direction = 0"), "is 1, or -1"));
  CHECK(contains(refusal("ofset = \"1 mm\""), "offset"));
  CHECK(contains(refusal("", "baud = 300\n"), "baud"));
  CHECK(contains(refusal("", "period = \"1 s\"\n"), "period"));
  CHECK(contains(refusal("", "port = \"/dev/ttyUSB0\"\n"), "port"));
}

TEST_CASE("what the wire needs and the robot file does not say, or says twice, is refused") {
  ServoEmulator bus(Kind::Dynamixel, 3);
  const auto trouble = [&](const std::string& kind, const std::array<std::string, 3>& wires) {
    const RobCommand rob(kThere);
    const std::string file = gantry_file(rob, wires);
    const ProcessResult result = rob("run", {"--robot", file, "--backend", on(kind, bus)});
    CHECK(result.exit_code == 74);
    return result.err;
  };
  CHECK(contains(trouble("dynamixel", {"", "", ""}),
                 "does not say how far axis x goes in a turn of its servo"));
  CHECK(contains(trouble("feetech-scs", {"travel = \"100 mm\"", "travel = \"100 mm\"", ""}),
                 "does not say how far axis theta goes"));
  CHECK(contains(
      trouble("dynamixel", {"id = 2\ntravel = \"100 mm\"", "id = 2\ntravel = \"100 mm\"", ""}),
      "axes x and y have the same id on the wire"));
  CHECK(contains(trouble("dynamixel",
                         {"id = 9\ntravel = \"200 mm\"", "id = 1\ntravel = \"200 mm\"", "id = 2"}),
                 "servo 9 (axis x)"));
  for (const int id : {1, 2, 3}) CHECK(eventually([&] { return !bus.torque(id); }));
}
