#include "motion/ahead/guide.h"

#include <doctest/doctest.h>

#include <random>

#include "tests/motion/ahead/ahead_run.h"
#include "tests/support/no_allocation.h"

using rob::test::AheadRun;

namespace {

void zigzag(AheadRun& run, std::mt19937& random) {
  std::uniform_real_distribution<double> place(0, 100);
  for (int i = 0; i < 20; ++i) run.line(place(random), place(random));
}

}  // namespace

TEST_CASE(
    "held at any instant the guide comes to rest within the axes' acceleration, and goes on") {
  std::mt19937 random(3);
  for (int attempt = 0; attempt < 12; ++attempt) {
    AheadRun run;
    run.bounds.speed = 0.3;
    run.bounds.miss = 0.002;
    zigzag(run, random);
    run.close();
    const int instant = std::uniform_int_distribution<int>(50, 4000)(random);
    for (int i = 0; i < instant; ++i) run.step();
    run.guide().brake();
    for (int i = 0; i < 1000; ++i) run.step();
    CHECK(run.guide().stands());
    run.guide().release();
    CHECK(run.run() > 0);
    for (int i = 0; i < 2; ++i) CHECK(run.peak_acceleration(i) <= 1.0001);
  }
}

TEST_CASE("an override changes the speed and no limit; the path is kept") {
  std::mt19937 random(4);
  for (int attempt = 0; attempt < 8; ++attempt) {
    AheadRun run;
    run.bounds.speed = 0.2;
    run.bounds.miss = 0.002;
    zigzag(run, random);
    run.close();
    for (int i = 0; i < 40; ++i) {
      run.ring().share = std::uniform_real_distribution<double>(0.1, 2)(random);
      for (int k = 0; k < 100; ++k) run.step();
      CHECK(run.guide().rate() <= 0.4 + 1e-9);
    }
    CHECK(run.run() > 0);
    for (int i = 0; i < 2; ++i) CHECK(run.peak_acceleration(i) <= 1.0001);
  }
}

TEST_CASE("at half the override a long line takes twice its cruise") {
  AheadRun run;
  run.bounds.speed = 0.2;
  run.bounds.miss = 0.001;
  run.ring().share = 0.5;
  run.line(200, 0);
  run.close();
  CHECK(run.run() == doctest::Approx(0.2 / 0.1 + 0.1).epsilon(0.002));
}
