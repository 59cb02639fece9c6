#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "motion/plan/profile.h"

using namespace rob::motion;

namespace {

struct Shape {
  Profile shape;
  double k;  ///< t_a = k·v/A (motion by S2's profiles)
};

const std::vector<Shape> kShapes{{Profile::Rectangular, 1},
                                 {Profile::Trapezoidal, 4.0 / 3},
                                 {Profile::Parabolic, 1.5},
                                 {Profile::Cosine, 2}};

/// The pulse as S2 names it, of peak 1.
double pulse(Profile shape, double x) {
  switch (shape) {
    case Profile::Trapezoidal:
      return std::min({4 * x, 1.0, 4 * (1 - x)});
    case Profile::Parabolic:
      return 4 * x * (1 - x);
    case Profile::Cosine:
      return (1 - std::cos(2 * std::numbers::pi * x)) / 2;
    default:
      return 1;
  }
}

}  // namespace

TEST_CASE("a profile takes d/v + t_a with a cruise, and 2·√(k·d/A) without") {
  for (const auto& [shape, factor] : kShapes) {
    const double k = factor;
    CAPTURE(k);
    CHECK(ProfileLaw(shape, 0.5, 2, 0).duration() == doctest::Approx(1 / 0.5 + k * 0.5 / 2));
    CHECK(ProfileLaw(shape, 100, 2, 0).duration() == doctest::Approx(2 * std::sqrt(k / 2)));
    // Given a time: v is the smaller root of 1 = v·(T − k·v/A).
    const ProfileLaw slow(shape, 0.5, 2, 10);
    CHECK(slow.duration() == doctest::Approx(10));
    const double v = slow.at(5).rate;
    CHECK(v * (10 - k * v / 2) == doctest::Approx(1));
    CHECK(v < 0.2);
    // Less time than it needs: what it needs.
    CHECK(ProfileLaw(shape, 0.5, 2, 1).duration() == doctest::Approx(1 / 0.5 + k * 0.5 / 2));
  }
}

TEST_CASE("a bound on jerk lowers a profile's acceleration just so far") {
  // Its steepest slope: 4·A/t_a of the ramps and of the parabola, π·A/t_a of the cosine.
  struct Steep {
    Profile shape;
    double k;
    double slope;
  };
  for (const auto& [shape, factor, slope] :
       {Steep{Profile::Trapezoidal, 4.0 / 3, 4}, Steep{Profile::Parabolic, 1.5, 4},
        Steep{Profile::Cosine, 2, std::numbers::pi}}) {
    const double k = factor;
    CAPTURE(k);
    // slope·A/t_a = slope·A²/(k·v) = 1 at v = 0.5.
    const double a = std::sqrt(k * 0.5 / slope);
    const ProfileLaw cruises = ProfileLaw::within_jerk(shape, 0.5, 2, 1, 0);
    CHECK(cruises.duration() == doctest::Approx(1 / 0.5 + k * 0.5 / a).epsilon(1e-9));
    CHECK(cruises.jerk() == doctest::Approx(1).epsilon(1e-9));
    // Without a cruise t_a = √(k/A): slope·A^1.5/√k = 1.
    const double b = std::pow(std::sqrt(k) / slope, 2.0 / 3);
    CHECK(ProfileLaw::within_jerk(shape, 100, 2, 1, 0).duration() ==
          doctest::Approx(2 * std::sqrt(k / b)).epsilon(1e-9));
    CHECK(ProfileLaw::within_jerk(shape, 0.5, 2, 1e3, 0).duration() ==
          ProfileLaw(shape, 0.5, 2, 0).duration());
    // Given a time that leaves more than the least: that time, and the jerk is kept.
    const ProfileLaw slow = ProfileLaw::within_jerk(shape, 0.5, 2, 1, 30);
    CHECK(slow.duration() == doctest::Approx(30));
    constexpr double kStep = 1e-4;
    for (double t = 0; t + kStep < 30; t += 0.01)
      CHECK(std::abs(slow.at(t + kStep).acceleration - slow.at(t).acceleration) <=
            kStep * (1 + 1e-6));
  }
}

TEST_CASE("a profile's acceleration is its pulse, cruise and the pulse mirrored") {
  for (const auto& [shape, factor] : kShapes) {
    const double k = factor;
    CAPTURE(k);
    const ProfileLaw law(shape, 0.5, 2, 0);
    const double t_a = k * 0.5 / 2;
    for (const double x : {0.05, 0.2, 0.4, 0.6, 0.9}) {
      CHECK(law.at(x * t_a).acceleration == doctest::Approx(2 * pulse(shape, x)));
      CHECK(law.at(law.duration() - x * t_a).acceleration == doctest::Approx(-2 * pulse(shape, x)));
    }
    CHECK(law.at(1).acceleration == 0);
    CHECK(law.at(1).rate == doctest::Approx(0.5));
  }
}

TEST_CASE("a profile's share and rate are the integrals of its acceleration, from rest to rest") {
  for (const auto& [shape, factor] : kShapes) {
    const double k = factor;
    for (const double rate : {0.5, 100.0}) {
      CAPTURE(k);
      const ProfileLaw law(shape, rate, 2, 0);
      constexpr int kSteps = 40000;
      const double dt = law.duration() / kSteps;
      double speed = 0;
      double share = 0;
      double worst = 0;
      for (int i = 0; i < kSteps; ++i) {  // midpoint rule
        const double a = law.at((i + 0.5) * dt).acceleration;
        share += speed * dt + a * dt * dt / 2;
        speed += a * dt;
        const ProfileLaw::Point p = law.at((i + 1) * dt);
        worst = std::max({worst, std::abs(p.rate - speed), std::abs(p.share - share)});
      }
      CHECK(worst < 1e-4);
      CHECK(law.at(0).share == 0);
      CHECK(law.at(0).rate == 0);
      CHECK(law.at(law.duration()).share == 1);
      CHECK(law.at(law.duration()).rate == 0);
      CHECK(law.at(law.time_at(0.3)).share == doctest::Approx(0.3));
    }
  }
}
