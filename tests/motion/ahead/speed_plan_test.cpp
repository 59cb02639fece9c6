#include "motion/ahead/speed_plan.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/random_text.h"

using namespace rob::motion;

namespace {

/// Straight along one axis, whose slope is dq/dσ: 10 rad/s² and at most 2 rad/s, 1 m/s are asked
/// for.
Piece sloping(double begin, double length, double slope) {
  Piece piece;
  piece.begin = begin;
  piece.length = length;
  piece.terms[0] = JointVector::Zero(1);
  piece.terms[1] = JointVector::Constant(1, slope);
  piece.acceleration = JointVector::Constant(1, 10);
  piece.fastest = 2 / slope;
  piece.pace = 1;
  return piece;
}

/// Pieces of any length, with slopes between 1 and 20.
std::vector<Piece> uneven_road(std::uint64_t seed, int pieces) {
  rob::test::Choice choice(seed);
  std::vector<Piece> road;
  double begin = 0;
  for (int i = 0; i < pieces; ++i) {
    const double slope = choice.percent(20) ? choice.between(5, 20) : choice.between(1, 2);
    road.push_back(sloping(begin, choice.between(1, 40) * 1e-3, slope));
    begin += road.back().length;
  }
  return road;
}

/// A road on which other speeds are asked for here and there, some of them far below what the axis
/// admits.
std::vector<Piece> road_of_speeds(std::uint64_t seed, int pieces) {
  rob::test::Choice choice(seed);
  std::vector<Piece> road;
  const double steep = 0.5 * choice.between(3, 20);
  double slope = 1;
  double fastest = 2;
  double begin = 0;
  for (int i = 0; i < pieces; ++i) {
    if (choice.percent(15)) {
      slope = choice.percent(50) ? 1 : steep;
      fastest = choice.percent(40) ? 0.01 * choice.between(2, 20) : 2;
    }
    const double length = choice.between(1, 10) * (fastest < 1 ? 0.25e-3 : 1e-3);
    road.push_back(sloping(begin, length, slope));
    road.back().fastest = std::min(road.back().fastest, fastest);
    begin += length;
  }
  return road;
}

std::size_t piece_at(const std::vector<Piece>& road, double sigma) {
  std::size_t at = 0;
  while (at + 1 < road.size() && road[at + 1].begin <= sigma) ++at;
  return at;
}

/// A guide that keeps to the rates of a plan and waits where it likes, or nowhere: where its mean
/// over so many steps is, each piece on which it was has to reckon with the slope there.
void check_reach(const std::vector<Piece>& road, const std::vector<SpeedPlan::Stretch>& planned,
                 double average, std::uint64_t seed, bool waits = true) {
  constexpr std::size_t kSteps = 200;
  rob::test::Choice choice(seed);
  std::vector<double> places(kSteps, 0.0);
  const double step = average / kSteps;
  const double end = road.back().begin + road.back().length;
  double eager = 1;
  double sum = 0;
  while (places.back() < end - 1e-9 && places.size() < 1000000) {
    if (waits && choice.percent(1)) eager = choice.percent(30) ? 0.0 : choice.below(1001) / 1000.0;
    if (eager == 0 && choice.percent(5)) eager = 1;
    const std::size_t at = piece_at(road, places.back());
    const double border = road[at].begin + road[at].length;
    places.push_back(std::min(places.back() + eager * planned[at].rate * step, border));
    sum += places.back() - places[places.size() - 1 - kSteps];
    const std::size_t on = piece_at(road, sum / kSteps);
    const std::size_t oldest = piece_at(road, places[places.size() - kSteps]);
    for (const std::size_t guide : {at, oldest})
      REQUIRE(planned[guide].most.slopes[0] >= road[on].terms[1][0]);
  }
  REQUIRE(places.back() >= end - 1e-9);
}

/// Each time that so many pieces more are known all that can be is planned for good.
std::vector<SpeedPlan::Stretch> planned_bit_by_bit(const std::vector<Piece>& road, double average,
                                                   std::size_t at_a_time) {
  SpeedPlan plan;
  plan.begin();
  std::vector<SpeedPlan::Stretch> fixed;
  for (std::size_t i = 0; i < road.size(); ++i) {
    plan.add(road[i]);
    const bool last = i + 1 == road.size();
    if (last) plan.end_at_rest();
    if (i % at_a_time != 0 && !last) continue;
    plan.plan(average);
    const std::size_t ready = plan.ready();
    for (std::size_t k = 0; k < ready; ++k) fixed.push_back(plan.stretch(k));
    plan.fix(ready);
  }
  return fixed;
}

}  // namespace

TEST_CASE("a run on an even road takes d/v + v/a, whatever its pieces") {
  for (const int pieces : {1, 7, 100}) {
    SpeedPlan plan;
    plan.begin();
    for (int i = 0; i < pieces; ++i) plan.add(sloping(2.0 * i / pieces, 2.0 / pieces, 1));
    plan.end_at_rest();
    plan.plan(0.2);
    CHECK(plan.time() == doctest::Approx(2 + 0.1).epsilon(1e-6));
    CHECK(plan.ready() == static_cast<std::size_t>(pieces));
  }
}

TEST_CASE("a slow place slows what is within reach at its own speed, not at that of the others") {
  SpeedPlan plan;
  plan.begin();
  const auto slope_at = [](int i) { return i == 500 ? 40.0 : 1.0; };  // 0.05 m/s over 2 mm
  for (int i = 0; i < 1000; ++i) plan.add(sloping(0.002 * i, 0.002, slope_at(i)));
  plan.end_at_rest();
  plan.plan(0.2);
  // The mean of 0.2 s at 0.05 m/s reaches 5 mm: 12 mm at most are so slow, which take 0.24 s. From
  // and to 1 m/s it takes 0.1 s to change, of twice the time that the way takes at 1 m/s; some
  // pieces of 2 mm do with the acceleration that the slow place has.
  CHECK(plan.time() >= 2 + 0.1 + 0.04 - 0.002);
  CHECK(plan.time() <= 2 + 0.1 + 0.24 + 2 * 0.1 + 0.06);
}

TEST_CASE("the mean of no guide that keeps the planned speed leaves what was reckoned with") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::vector<Piece> road = uneven_road(seed, 60);
    const double average = 0.05 * static_cast<double>(1 + seed % 5);
    SpeedPlan plan;
    plan.begin();
    for (const Piece& piece : road) plan.add(piece);
    plan.end_at_rest();
    plan.plan(average);
    CAPTURE(seed);
    std::vector<SpeedPlan::Stretch> planned;
    for (std::size_t i = 0; i < road.size(); ++i) planned.push_back(plan.stretch(i));
    check_reach(road, planned, average, seed);
  }
}

TEST_CASE("so it is where the road becomes known little by little") {
  constexpr double kAverage = 0.1;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const std::vector<Piece> road = uneven_road(seed, 300);
    const auto fixed = planned_bit_by_bit(road, kAverage, 7);
    CAPTURE(seed);
    REQUIRE(fixed.size() == road.size());
    check_reach(road, fixed, kAverage, seed);
  }
}

TEST_CASE("so it is where what becomes known is to be driven faster than all before") {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    const std::vector<Piece> road = road_of_speeds(seed, 120);
    const double average = seed % 3 == 0 ? 0.1 : 0.3;
    const auto fixed = planned_bit_by_bit(road, average, 1 + seed % 7);
    CAPTURE(seed);
    REQUIRE(fixed.size() == road.size());
    check_reach(road, fixed, average, seed, false);
  }
}
