// The angle of a ZONE, from traces.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/rob_command.h"
#include "tests/support/trace_file.h"

using rob::test::contains;
using rob::test::ProcessResult;
using rob::test::RobCommand;

namespace {

const std::string kXyza = std::string(ROB_SOURCE_DIR) + "/tests/bench/xyza.toml";

/// x comes to its end and axis a turns: what both are away from the point, at the place where the
/// greater of the two is least, mm or deg.
double missed(const std::string& zone) {
  const RobCommand rob("MOVE(200, 0, 0, 0) AT 300mm/s ZONE " + zone +
                       "\nMOVE(200, 0, 0, 200) AT 300deg/s\n");
  const std::string file = rob.file("trace.csv");
  const ProcessResult result = rob("run", {"--fast", "--robot", kXyza, "--trace", file});
  REQUIRE_MESSAGE(result.exit_code == 0, result.err);
  double least = 1e9;
  for (const auto& row : rob::test::parse_trace(rob::test::read_whole_file(file)).rows)
    least = std::min(least, std::max(200 - row.q[0], row.q[3]));
  return least;
}

}  // namespace

TEST_CASE("a corner keeps the angle of its ZONE") {
  // In the middle of the parabola both have the same way to go, 1 mm and 1 deg being one σ.
  CHECK(missed("100mm 1deg") == doctest::Approx(1).epsilon(0.05));
  CHECK(missed("100mm 4deg") == doctest::Approx(4).epsilon(0.05));
  CHECK(missed("100%  2deg") == doctest::Approx(2).epsilon(0.05));
  CHECK(missed("3mm 20deg") == doctest::Approx(3).epsilon(0.05));
}

TEST_CASE("without an angle the robot's counts") {
  CHECK(missed("100mm") == doctest::Approx(missed("100mm 1deg")));  // xyza.toml names none
}

TEST_CASE("under Paul's law the angle of a ZONE bounds nothing, and a warning says so") {
  const std::string rest = "\nMOVE(100, 100, 0)\n";
  const ProcessResult with = RobCommand("MOVE(100, 0, 0) ZONE 5mm 2deg" + rest)("check");
  const ProcessResult without = RobCommand("MOVE(100, 0, 0) ZONE 5mm" + rest)("check");
  CHECK(with.exit_code == 0);
  CHECK(with.out == without.out);
  CHECK(contains(with.err, "test.rob:1: warning[W645]: under Paul's law the angle of a ZONE"));
  CHECK(without.err.empty());
  const ProcessResult exact = RobCommand("MOVE(100, 0, 0) ZONE 0mm 2deg" + rest)("check");
  CHECK_FALSE(contains(exact.err, "W645"));
}
