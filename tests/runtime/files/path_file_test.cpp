#include "runtime/files/path_file.h"

#include <doctest/doctest.h>

#include "tests/motion/ahead/ahead_run.h"
#include "tests/support/process.h"
#include "tests/support/topp.h"

using namespace rob;

TEST_CASE("a planned path is written with both ends of each of its pieces, in mm and deg") {
  const test::ScratchFolder scratch;
  const std::string file = (scratch.path() / "path.csv").string();
  test::AheadRun run;
  run.bounds.speed = 0.3;
  run.bounds.miss = 0.001;
  runtime::PathFile written(file, run.robot());
  run.planner().tell(written);
  run.line(100, 0);
  run.line(100, 50);
  run.close();
  const double time = run.run();
  written.save();

  const auto nodes = test::parse_topp_path(test::read_whole_file(file));
  CHECK(nodes.front().q == test::AxisValues{0, 0, 0});
  CHECK(nodes.front().dq == test::AxisValues{1, 0, 0});
  CHECK(nodes.back().sigma == doctest::Approx(150));
  CHECK(nodes.back().q[0] == doctest::Approx(100));
  CHECK(nodes.back().q[1] == doctest::Approx(50));
  CHECK(nodes.back().dq[1] == doctest::Approx(1));
  // A corner that misses by 1 mm takes 4/√2 mm of each leg, and turns by (−1, 1) within twice that.
  const double half = 4 / std::sqrt(2.0);
  CHECK(nodes[2].sigma == doctest::Approx(100 - half));
  CHECK(nodes[2].ddq[1] == doctest::Approx(1 / (2 * half)));
  const double best =
      test::time_optimal(nodes, {{1000, 1000, 573}, {1000, 1000, 573}, 300}, 10'000).time;
  CHECK(time == doctest::Approx(best).epsilon(0.005));
}
