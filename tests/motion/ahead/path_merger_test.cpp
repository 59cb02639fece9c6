#include "motion/ahead/path_merger.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/motion/ahead/ahead_run.h"
#include "tests/support/ordered_distance.h"

// Every axis has 1 m/s and 1 m/s²; references every millisecond. Times are those of straight lines
// and circles at even speed, by hand; accelerations are differences of the references.

namespace rob::test {

namespace {

using Eigen::Vector3d;
using Places = std::vector<Vector3d>;  ///< mm

struct DensePath : AheadRun {
  DensePath(double speed, double miss) : AheadRun(fast_table(), 32768) {
    bounds.speed = speed;
    bounds.miss = miss;
  }
  /// From where it stands, rounded to whole nanometres, as a program has them.
  void along(const Places& places) {
    for (const Vector3d& place : places) {
      commanded.push_back((place * 1e6).array().round() / 1e6);
      line(commanded.back().x(), commanded.back().y());
    }
    close();
  }
  double acceleration() const {
    double most = 0;
    for (std::size_t k = 2; k < references().size(); ++k) {
      for (int i = 0; i < 2; ++i) {
        const auto q = [&](std::size_t at) { return references()[at].q[i]; };
        most = std::max(most, std::abs(q(k) - 2 * q(k - 1) + q(k - 2)) / 1e-6);
      }
    }
    return most;
  }
  double speed() const {
    double most = 0;
    for (std::size_t k = 1; k < references().size(); ++k)
      most = std::max(most, (references()[k].q - references()[k - 1].q).norm() / 1e-3);
    return most;
  }
  /// mm, in the order of the path, within a hundredth. Straight from reference to reference.
  double deviation() const {
    constexpr int kParts = 20;
    Places way;
    Vector3d last = Vector3d::Zero();
    for (const motion::PathPoint& point : references()) {
      const Vector3d next(1000 * point.q[0], 1000 * point.q[1], 0);
      for (int k = 1; k <= kParts; ++k) way.push_back(last + (next - last) * k / kParts);
      last = next;
    }
    return ordered_distance(way, commanded, 1);
  }
  Places commanded{Vector3d::Zero()};
};

Places arc_of(double radius, double chord, double angle) {
  Places places;
  const int count = static_cast<int>(std::lround(radius * angle / chord));
  for (int i = 1; i <= count; ++i) {
    const double at = angle * i / count;
    places.emplace_back(radius * std::sin(at), radius - radius * std::cos(at), 0);
  }
  return places;
}

}  // namespace

TEST_CASE("a circle takes as long in chords of any length, and keeps its acceleration") {
  const double circle = 2 * std::numbers::pi * 20;
  for (const double chord : {0.005, 0.02, 0.1}) {
    CAPTURE(chord);
    DensePath path(0.1, 1e-4);
    path.along(arc_of(20, chord, 2 * std::numbers::pi));
    // At 100 mm/s a circle of 20 mm takes half of what the axes have.
    CHECK(path.run() == doctest::Approx(circle / 100 + 0.1).epsilon(0.01));
    CHECK(path.acceleration() <= 1.02);
    CHECK(path.speed() <= 0.1 * 1.0005);
    CHECK(path.deviation() <= 0.101);
    CHECK((path.references().back().q - path.end()).norm() < 1e-12);
  }
}

TEST_CASE("a straight line that rounding or noise has made crooked is run straight through") {
  DensePath path(0.1, 1e-5);
  Places places;
  for (int i = 1; i <= 2000; ++i)
    places.emplace_back(0.05 * i, 0.002 * ((i * 7919) % 21 - 10) / 10.0, 0);
  path.along(places);
  CHECK(path.run() == doctest::Approx(1.1).epsilon(0.03));
  CHECK(path.acceleration() <= 1.02);
  CHECK(path.deviation() <= 0.0101);
}

TEST_CASE("a straight line takes as long in legs whose ends are rounded to any digit") {
  // Along 30° the x axis, which bounds the ramp, has 1/cos 30° of its acceleration to give.
  const double time = 2 + 0.1 * std::cos(std::numbers::pi / 6);
  for (const double unit : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
    for (const double speed : {0.1, 0.001}) {
      CAPTURE(unit);
      CAPTURE(speed);
      DensePath path(speed, 1e-4);
      Places places;
      for (int i = 1; i <= 20; ++i) {
        const Vector3d place(10 * i * std::cos(std::numbers::pi / 6), 5 * i, 0);
        places.push_back((place / unit).array().round() * unit);
      }
      for (const Vector3d& place : places) path.line(place.x(), place.y());
      path.close();
      const double expected = speed == 0.1 ? time : 200 + 0.001 * std::cos(std::numbers::pi / 6);
      CHECK(path.run() == doctest::Approx(expected).epsilon(0.005));
      CHECK(path.acceleration() <= 1.02);
    }
  }
}

TEST_CASE("a period is run to its end however many pieces it has, under a bound on jerk, too") {
  // 100 chords in a period at 100 mm/s.
  DensePath path(0.1, 1e-4);
  path.bounds.window = 0.02;
  path.along(arc_of(20, 0.001, 0.5));
  CHECK(path.run() > 0);
  CHECK(path.acceleration() <= 1.02);
}

TEST_CASE("short legs between long ones: the curve begins and ends on the long legs") {
  DensePath path(0.1, 1e-4);
  Places places{{50, 0, 0}};
  for (const Vector3d& place : arc_of(5, 0.05, std::numbers::pi / 2))
    places.push_back(Vector3d(50, 0, 0) + place);
  places.emplace_back(55, 60, 0);
  places.emplace_back(-20, 60, 0);
  path.along(places);
  // 50 mm + a quarter of 5 mm at √(A·r) = 70.7 mm/s + 55 mm, a corner, 75 mm. To slow down from 100
  // and back takes 2·(v − w)²/2av = 8.6 ms; the corner within 0.1 mm, without acceleration along
  // the other leg, 90 ms or so.
  const double bend = 5 * std::numbers::pi / 2;
  const double even = (50 + 55 + 75) / 100.0 + bend / 70.7 + 0.1 + 0.0086;
  const double time = path.run();
  CHECK(time > even);
  CHECK(time < even + 0.1);
  CHECK(path.acceleration() <= 1.02);
  CHECK(path.deviation() <= 0.101);
}

TEST_CASE("each motion has its place on the path, in order, one behind the other") {
  DensePath path(0.1, 1e-4);
  path.along(arc_of(20, 0.05, 1));
  std::uint32_t number = 0;
  double end = 0;
  path.planner().work();
  while (const motion::PathLeg* leg = path.ring().next_leg()) {
    CHECK(leg->segment.number == ++number);
    CHECK(leg->begin == doctest::Approx(end).epsilon(1e-12));
    CHECK(leg->end > leg->begin);
    end = leg->end;
    path.ring().pop_leg();
  }
  CHECK(number == 400);
  CHECK(end == doctest::Approx(0.02).epsilon(0.001));
}

TEST_CASE("a path whose program comes late stops at what it knows, and goes on from there") {
  DensePath path(0.1, 1e-4);
  const Places places = arc_of(20, 0.05, 2);
  const auto half = static_cast<std::ptrdiff_t>(places.size() / 2);
  for (auto place = places.begin(); place != places.begin() + half; ++place)
    path.line(place->x(), place->y());
  for (int i = 0; i < 1000; ++i) path.step();
  CHECK(path.stands());
  CHECK((path.references().back().q - path.end()).norm() < 1e-12);
  for (auto place = places.begin() + half; place != places.end(); ++place)
    path.line(place->x(), place->y());
  path.close();
  CHECK(path.run() > 0);
  CHECK((path.references().back().q - path.end()).norm() < 1e-12);
  CHECK(path.acceleration() <= 1.02);
}

}  // namespace rob::test
