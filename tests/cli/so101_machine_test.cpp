// The SO-101, commanded in its axes: the same program in the simulation and on its bus.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/emulators/servo_emulator.h"
#include "tests/support/rob_command.h"

using nlohmann::json;
using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;
using rob::test::ServoEmulator;

namespace {

const std::string kArm = "ROBOT \"so101\"\n";

}  // namespace

TEST_CASE(
    "the SO-101 in the simulation and over feetech: goes to the same places in the same time") {
  const RobCommand rob(kArm +
                       "MOVE (30, 20, -20, 60, 0, 60)\nMOVE (-30, 20, -20, 60, 90, 10)\nSTOP\n");
  const ProcessResult simulated = rob("run", {"--fast", "--json"});
  REQUIRE_MESSAGE(simulated.exit_code == 0, simulated.err);
  ServoEmulator bus(ServoEmulator::Kind::Feetech, 6);
  const ProcessResult wired = rob("run", {"--json", "--backend", "feetech:" + bus.path()});
  REQUIRE_MESSAGE(wired.exit_code == 0, wired.err);
  const double planned = json::parse(simulated.out)["planned_s"];
  CHECK(json::parse(wired.out)["planned_s"].get<double>() ==
        doctest::Approx(planned).epsilon(0.01));
  CHECK(bus.moved_for() == doctest::Approx(planned).epsilon(0.1));
  const double end[] = {-30, 20, -20, 60, 90, 10};
  for (int id = 1; id <= 6; ++id) {
    CAPTURE(id);
    CHECK(std::abs(bus.position(id) - (2048 + end[id - 1] * 4096 / 360)) < 1);
    CHECK(std::abs(json::parse(simulated.out)["final"]["joints"][static_cast<std::size_t>(id - 1)]
                       .get<double>() -
                   end[id - 1]) < 1);
  }
}

TEST_CASE("what leads a tool is refused on the SO-101, and nothing moves") {
  const auto refused = [](const std::string& program, int exit_code) {
    const ProcessResult result = RobCommand(kArm + program)("run", {"--fast"});
    CAPTURE(program);
    CAPTURE(result.err);
    CHECK(result.exit_code == exit_code);
    CHECK(contains(result.err, "commanded in its axes alone, with MOVE and JOG JOINT"));
  };
  refused("MOVEL (30, 20, -20, 60, 0, 60)\n", 70);
  refused("MOVE POSE(300mm, 0mm, 100mm, 0deg, 0deg, 0deg)\n", 65);
  refused("VAR p = 30deg\nMOVEL (p, 20, -20, 60, 0, 60)\n", 70);
  refused("MOVEC VIA (10, 10, 0, 0, 0, 0) TO (20, 0, 0, 0, 0, 0)\n", 70);
  refused("JOG WORLD (10deg/s, 0deg/s, 0deg/s, 0deg/s, 0deg/s, 0deg/s) FOR 1s\n", 70);
}
