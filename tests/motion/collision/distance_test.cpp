#include "motion/collision/distance.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/split_mix.h"

using namespace rob::motion;
using Eigen::Vector3d;
using rob::SplitMix;

namespace {

Pose upright(const Vector3d& position) { return {position, Eigen::Quaterniond::Identity()}; }

double between(SplitMix& random, double least, double most) {
  return least + (most - least) * random.share();
}

Vector3d place(SplitMix& random, double reach) {
  return {between(random, -reach, reach), between(random, -reach, reach),
          between(random, -reach, reach)};
}

Pose pose(SplitMix& random) {
  const FixedAngles angles{between(random, -3, 3), between(random, -1.5, 1.5),
                           between(random, -3, 3)};
  return {place(random, 0.3), orientation_from(angles)};
}

Capsule capsule(SplitMix& random) {
  return {place(random, 1), place(random, 1), between(random, 0, 0.1)};
}

/// The least value of a convex function on [0, 1], by the golden section.
double least_of(const std::function<double(double)>& f) {
  constexpr double kGolden = 1 / std::numbers::phi;
  double low = 0;
  double high = 1;
  for (int i = 0; i < 60; ++i) {
    const double left = high - (high - low) * kGolden;
    const double right = low + (high - low) * kGolden;
    (f(left) < f(right) ? high : low) = f(left) < f(right) ? right : left;
  }
  return std::min({f(0), f(1), f((low + high) / 2)});
}

Vector3d on(const Capsule& capsule, double t) {
  return capsule.from + t * (capsule.to - capsule.from);
}

double outside(const Vector3d& point, const Box& box) {
  const Vector3d seen = place_of(point, inverse(box.centre));
  return (seen.cwiseAbs() - box.half).cwiseMax(0).norm();
}

}  // namespace

TEST_CASE("a capsule is as far from bodies as their drawings say") {
  // Along x from 0 to 2 m, 0.1 m thick.
  const Capsule beam{{0, 0, 0}, {2, 0, 0}, 0.1};
  CHECK(distance(beam, Sphere{{1, 0, 0.5}, 0.2}) == doctest::Approx(0.2));
  CHECK(distance(beam, Sphere{{5, 4, 0}, 1}) == doctest::Approx(5 - 1.1));
  CHECK(distance(beam, Capsule{{1, -1, 0.5}, {1, 1, 0.5}, 0.1}) == doctest::Approx(0.3));
  CHECK(distance(beam, Capsule{{0, 0, 1}, {2, 0, 1}, 0.1}) == doctest::Approx(0.8));
  CHECK(distance(beam, Capsule{{3, 0, 0}, {4, 0, 0}, 0.1}) == doctest::Approx(0.8));
  CHECK(distance(beam, Box{upright({1, 0, 1}), {0.5, 0.5, 0.5}}) == doctest::Approx(0.4));
  CHECK(distance(beam, Box{upright({1, 0, 0}), {0.5, 0.5, 0.5}}) == doctest::Approx(-0.6));
  CHECK(distance(beam, HalfSpace{-0.5}) == doctest::Approx(0.4));
  CHECK(distance(beam, HalfSpace{0.2}) == doctest::Approx(-0.3));
  // A cube on one edge: its other edge, √0.5 m above the centre, runs along x.
  const Pose turned{{1, 0, -2}, orientation_from({std::numbers::pi / 4, 0, 0})};
  CHECK(distance(beam, Box{turned, {0.5, 0.5, 0.5}}) == doctest::Approx(2 - std::sqrt(0.5) - 0.1));
}

TEST_CASE("the closed forms find what a search along the segments finds") {
  SplitMix random(1);
  for (int i = 0; i < 2000; ++i) {
    CAPTURE(i);
    Capsule a = capsule(random);
    Capsule b = capsule(random);
    if (i % 5 == 0) a.to = a.from;                                     // a sphere
    if (i % 7 == 0) b.to = b.from + 2 * (a.to - a.from);               // parallel
    if (i % 11 == 0) b.to = b.from + (a.to - a.from) + 1e-9 * b.from;  // nearly so
    if (i % 13 == 0) a.to.tail<2>() = a.from.tail<2>();                // along x
    Box box{pose(random), place(random, 0.4).cwiseAbs()};
    if (i % 3 == 0) box.centre.orientation.setIdentity();
    const Sphere ball{b.from, b.radius};

    const double to_ball = least_of([&](double t) { return (on(a, t) - ball.centre).norm(); });
    CHECK(std::fabs(distance(a, ball) - (to_ball - a.radius - ball.radius)) < 1e-7);
    const double to_box = least_of([&](double t) { return outside(on(a, t), box); });
    if (to_box > 1e-6) CHECK(std::fabs(distance(a, box) - (to_box - a.radius)) < 1e-7);
    if (to_box == 0) CHECK(distance(a, box) < -a.radius + 1e-7);
    if (i >= 400) continue;  // a search within a search takes long
    const double to_capsule = least_of(
        [&](double s) { return least_of([&](double t) { return (on(a, s) - on(b, t)).norm(); }); });
    CHECK(std::fabs(distance(a, b) - (to_capsule - a.radius - b.radius)) < 1e-7);
    CHECK(distance(a, b) == doctest::Approx(distance(b, a)));
  }
}

TEST_CASE("within a box the distance is the way out of it") {
  SplitMix random(3);
  int inside = 0;
  for (int i = 0; i < 4000 && inside < 60; ++i) {
    CAPTURE(i);
    Capsule a = capsule(random);
    a.radius = 0;
    a.to = a.from + 0.5 * (a.to - a.from);
    if (i % 5 == 0) a.to = a.from;
    if (i % 7 == 0) a.to.tail<2>() = a.from.tail<2>();
    const Box box{i % 3 == 0 ? upright({0.1, 0, 0}) : pose(random), {0.3, 0.4, 0.5}};
    const auto moved_by = [&](const Vector3d& way) {
      return Capsule{a.from + way, a.to + way, a.radius};
    };
    const double depth = -distance(a, box);
    if (depth <= 1e-4) continue;
    ++inside;
    // No shorter way leads out of it, and some way that is little longer does.
    bool out = false;
    for (int k = 0; k < 1000 && !out; ++k) {
      const Vector3d way = place(random, 1).normalized();
      out = distance(moved_by(1.1 * depth * way), box) > 0;
      if (k >= 10) continue;
      const Capsule less = moved_by(0.999 * depth * way);
      CHECK(least_of([&](double t) { return outside(on(less, t), box); }) < 1e-9);
    }
    CHECK(out);
  }
  CHECK(inside == 60);
}

TEST_CASE("pressing on deeper is less and less distance") {
  const Box box{upright({0, 0, 0}), {0.03, 0.03, 0.03}};
  double before = 1;
  for (double x = -0.05; x < 0; x += 0.001) {
    const double now = distance(Capsule{{x, 0, -0.1}, {x, 0, 0.1}, 0.01}, box);
    CHECK(now < before);
    before = now;
  }
}
