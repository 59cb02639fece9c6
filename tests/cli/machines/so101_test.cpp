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
  const auto refused = [](const std::string& line, const std::string& words) {
    const RobCommand rob(kArm + "MOVE (10, 0, 0, 0, 0, 0)\nVAR a = 30deg\n" + line + "\n");
    CAPTURE(line);
    for (const std::string command : {"run", "check"}) {
      const ProcessResult result = rob(command, {});
      CAPTURE(result.err);
      CHECK(result.exit_code == 65);
      CHECK(contains(result.err, ":4:"));
      CHECK(contains(result.err, words));
      CHECK(contains(result.err, "JOG JOINT"));
    }
  };
  const std::string leading = "leading the tool is not possible on so101";
  refused("MOVEL (30, 20, -20, 60, 0, 60)", leading);
  refused("MOVEL (a, 20, -20, 60, 0, 60)", leading);
  refused("MOVEL BY (z: 10mm)", leading);
  refused("MOVEC VIA (10, 10, 0, 0, 0, 0) TO (20, 0, 0, 0, 0, 0)", leading);
  refused("MOVES VIA (10, 10, 0, 0, 0, 0) TO (20, 0, 0, 0, 0, 0)", leading);
  refused("JOG WORLD (10deg/s, 0deg/s, 0deg/s, 0deg/s, 0deg/s, 0deg/s) FOR 1s", leading);
  refused("MOVE HERE", leading);
  refused("MOVE HERE + VEC(0mm, 0mm, 10mm)", leading);
  refused("MOVE POSE(300mm, 0mm, 100mm, 0deg, 0deg, 0deg)", "so101 is commanded in its axes alone");
}

TEST_CASE("a point that was taught in its joints is gone to on the SO-101") {
  const RobCommand rob(
      kArm +
      "POINT part\nMOVE (10, 20, 0, 0, 0, 30)\nTEACH part\nMOVE (0, 0, 0, 0, 0, 0)\n"
      "MOVE part\nSTOP\n");
  const ProcessResult result = rob("run", {"--fast", "--json"});
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  CHECK(json::parse(result.out)["final"]["joints"][0].get<double>() == doctest::Approx(10));
}
