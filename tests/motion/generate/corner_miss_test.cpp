#include "motion/generate/corner_miss.h"

#include <doctest/doctest.h>

#include <cmath>

#include "motion/kinematics/gantry_kinematics.h"
#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_library.h"
#include "tests/motion/generate/gantry_run.h"

using namespace rob::motion;
using namespace rob::test;

TEST_CASE("the published program misses its corners by 4.0, 9.6, 10.3 and 0.0 mm") {
  GantryRun run;
  const JointVector from[] = {gantry_q(0, 0, 0), gantry_q(40, 40, 0), gantry_q(140, 40, 0),
                              gantry_q(90, 126, 0)};
  const SegmentDescriptor segments[] = {run.move(40, 40, 0), run.move(140, 40, 0),
                                        run.move(90, 126, 0), run.move(40, 40, 0),
                                        *run.planner().stop(5)};
  const double expected_mm[] = {4.0, 9.6, 10.3, 0.0};
  for (std::size_t i = 0; i < 4; ++i) {
    const double miss = corner_miss(*run.robot().kinematics, from[i], segments[i], segments[i + 1]);
    CHECK(std::abs(miss * 1000 - expected_mm[i]) < 0.05);
  }
}

TEST_CASE("a symmetric corner misses its point by 3/16·t_acc·Δv") {
  const GantryKinematics gantry;
  // Equal speeds in and out: the curve is symmetric and nearest in its middle.
  for (double turn = 0.2; turn < 3.1; turn += 0.3) {
    const JointVector in = gantry_q(20, 0, 0);
    const JointVector out = gantry_q(20 * std::cos(turn), 20 * std::sin(turn), 0);
    CHECK(corner_miss(gantry, gantry_q(100, 100, 0), in, out, 1.375) ==
          doctest::Approx(3.0 / 16 * 1.375 * (out - in).norm()).epsilon(1e-9));
  }
}

TEST_CASE("turning back misses the point by 3/8·t_acc·v, a straight pass not at all") {
  const GantryKinematics gantry;
  const JointVector via = gantry_q(100, 0, 0);
  const JointVector v = gantry_q(16, 0, 0);
  CHECK(corner_miss(gantry, via, v, -v, 1) == doctest::Approx(0.006));
  CHECK(corner_miss(gantry, via, v, v, 1) == doctest::Approx(0).epsilon(1e-12));
  // Slower on the same line: the point lies on the path, though it is not passed at t = 0.
  CHECK(corner_miss(gantry, via, v, v / 2, 1) < 1e-9);
}

TEST_CASE("a corner in which the tool only turns misses nothing") {
  const GantryKinematics gantry;
  CHECK(corner_miss(gantry, gantry_q(100, 100, 0), gantry_q(0, 0, 20), gantry_q(0, 0, -20),
                    1.375) == 0);
}

TEST_CASE("the miss is the least distance of the references from the target") {
  const RobotModel robot = embedded_robot("gantry");
  RandomTargets targets(robot, 17);
  for (int n = 0; n < 20; ++n) {
    GantryRun run;
    const JointVector via = targets.next();
    const SegmentDescriptor in = run.move(move_to(via));
    const SegmentDescriptor out = run.move(move_to(targets.next()));
    run.stop();
    run.close();
    run.finish();
    double least = 1;
    for (const GeneratorSample& sample : run.samples()) {
      const double t = sample.reference.time;
      if (t < in.duration || t > in.duration + 2.75 + 1e-9) continue;  // in the corner
      least = std::min(least, (sample.reference.q - via).head<2>().norm());
    }
    const double miss = corner_miss(*run.robot().kinematics, run.robot().start, in, out);
    CHECK(miss <= least + 1e-12);
    CHECK(miss >= least - 0.029 * 0.005);  // half a period at 20·√2 mm/s
  }
}
