#include "tests/motion/ahead/ahead_run.h"

#include <doctest/doctest.h>

using rob::test::AheadRun;

namespace {

void triangle(AheadRun& run) {
  run.line(40, 40);
  run.line(140, 40);
  run.line(90, 126);
  run.line(40, 40);
  run.close();
}

}  // namespace

TEST_CASE("a line from rest to rest takes d/v + v/a") {
  AheadRun run;
  run.bounds.speed = 0.3;
  run.line(200, 0);
  run.close();
  CHECK(run.run() == doctest::Approx(0.2 / 0.3 + 0.3).epsilon(0.002));
  CHECK(run.references().back().q[0] == doctest::Approx(0.2).epsilon(1e-12));
}

TEST_CASE("the triangle") {
  AheadRun run;
  run.bounds.speed = 0.1;
  run.bounds.miss = 0.0001;
  triangle(run);
  const double t = run.run();
  MESSAGE(t << " a " << run.peak_acceleration(0) << " " << run.peak_acceleration(1) << " miss " << run.miss(140, 40)<< " " << run.miss(40, 40));
}

TEST_CASE("more") {
  for (double f : {0.1, 0.3}) for (double w : {0.0, 0.02}) {
    AheadRun run;
    run.bounds.speed = f;
    run.bounds.miss = 0.0001;
    run.bounds.window = w;
    run.line(40, 40);
    double t0 = run.run(10); (void)t0;
    triangle(run);
    const double t = run.run();
    MESSAGE("triangle " << f << " window " << w << " " << t << " a " << run.peak_acceleration(0) << " " << run.peak_acceleration(1) << " j " << run.peak_jerk(0) << " miss " << run.miss(140, 40)<< " " << run.miss(90, 126));
    AheadRun circle;
    circle.bounds = run.bounds;
    for (int i = 1; i <= 1000; ++i) circle.line(50 - 50 * std::cos(i * 2 * M_PI / 1000), 50 * std::sin(i * 2 * M_PI / 1000));
    circle.close();
    const double tc = circle.run();
    MESSAGE("circle " << f << " window " << w << " " << tc << " a " << circle.peak_acceleration(0) << " " << circle.peak_acceleration(1) << " j " << circle.peak_jerk(0));
    AheadRun hatch;
    hatch.bounds = run.bounds;
    for (int i = 0; i < 200; ++i) { hatch.line(i % 2 ? 0 : 50, i); hatch.line(i % 2 ? 0 : 50, i + 1);}
    hatch.close();
    const double th = hatch.run();
    MESSAGE("hatch " << f << " window " << w << " " << th << " a " << hatch.peak_acceleration(0) << " " << hatch.peak_acceleration(1) << " j " << hatch.peak_jerk(0));
    AheadRun straight(rob::test::fast_table(), 16384);
    straight.bounds = run.bounds;
    for (int i = 1; i <= 10000; ++i) straight.line(i * 0.02, 0);
    straight.close();
    const double ts = straight.run();
    MESSAGE("straight " << f << " window " << w << " " << ts << " a " << straight.peak_acceleration(0) << " " << straight.peak_acceleration(1) << " j " << straight.peak_jerk(0));
  }
}
