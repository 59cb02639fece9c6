#include "motion/ahead/reference_average.h"

#include <doctest/doctest.h>

using namespace rob::motion;

namespace {

constexpr double kMeanPeriod = 0.004;
constexpr int kPeriods = 40;
constexpr double kWay = 5e-5;

/// A run of one axis, 0.05 mm, so short that the guide is at its end within one period:
/// 2·√(d/a) = 2 ms.
void write_short_run(PathRing& ring) {
  Piece& piece = ring.draft(0);
  piece.length = kWay;
  piece.terms[0] = JointVector::Zero(1);
  piece.terms[1] = JointVector::Constant(1, 1);
  piece.acceleration = JointVector::Constant(1, 50);
  ring.set_square(0, 0);
  ring.set_run_end(0, true);
  ring.publish(1);
}

}  // namespace

TEST_CASE("the mean of a motion within one period takes all of its time") {
  for (const bool of_sigma : {false, true}) {
    CAPTURE(of_sigma);
    PathRing ring(4, 4);
    write_short_run(ring);
    const JointVector start = JointVector::Zero(1);
    Guide guide(ring, start);
    ReferenceAverage average(ring, start);
    average.begin_run(kPeriods, of_sigma, guide);
    for (int k = 1; k < kPeriods; ++k) {
      guide.step(k * kMeanPeriod, [](const Guide::Part&) {});
      average.take(guide);
      REQUIRE(guide.at_run_end());
      CHECK_FALSE(average.stands());
      CHECK(average.mean().q[0] == doctest::Approx(kWay * k / kPeriods));
      CHECK(average.sigma() == doctest::Approx(kWay * k / kPeriods));
    }
    guide.step(kPeriods * kMeanPeriod, [](const Guide::Part&) {});
    average.take(guide);
    CHECK(average.stands());
    CHECK(average.mean().q[0] == doctest::Approx(kWay).epsilon(1e-12));
  }
}
