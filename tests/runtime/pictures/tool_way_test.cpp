// The polyline of a picture beside the way that it stands for.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "motion/robots/robot_library.h"
#include "runtime/pictures/tool_way.h"

using Eigen::Vector3d;
using rob::runtime::Snapshot;
using rob::runtime::ToolWay;

namespace {

constexpr double kPeriod = 0.01;  // s
constexpr double kRadius = 0.02;  // m
constexpr double kTurn = 5;       // rad/s: 100 mm/s

/// A circle in the plane of the gantry, as it hands out references.
Snapshot on_circle(double time, int line) {
  const double turn = kTurn * time;
  Snapshot snapshot;
  rob::motion::JointReference& reference = snapshot.sample.reference;
  reference.time = time;
  reference.q = Vector3d(kRadius * std::cos(turn), kRadius * std::sin(turn), 0);
  reference.qd = kTurn * kRadius * Vector3d(-std::sin(turn), std::cos(turn), 0);
  reference.qdd = -kTurn * kTurn * kRadius * Vector3d(std::cos(turn), std::sin(turn), 0);
  snapshot.sample.tag = static_cast<std::uint32_t>(line);
  return snapshot;
}

Snapshot on_line(double time, double x, int line) {
  Snapshot snapshot;
  rob::motion::JointReference& reference = snapshot.sample.reference;
  reference.time = time;
  reference.q = Vector3d(x, 0, 0);
  reference.qd = Vector3d(0.1, 0, 0);
  reference.qdd = Vector3d::Zero();
  snapshot.sample.tag = static_cast<std::uint32_t>(line);
  return snapshot;
}

double distance(const Vector3d& p, const ToolWay::Stretch& stretch) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < stretch.corners.size(); ++i) {
    const Vector3d from = stretch.corners[i - 1];
    const Vector3d way = stretch.corners[i] - from;
    const double share = std::clamp((p - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - from - share * way).norm());
  }
  return least;
}

}  // namespace

TEST_CASE("a polyline is within 8 um of a circle whose references are 1 mm apart") {
  const auto robot = rob::motion::embedded_robot("gantry");
  ToolWay way(robot);
  const int periods = static_cast<int>(2 * std::numbers::pi / kTurn / kPeriod);
  for (int i = 0; i <= periods; ++i) way.take(on_circle(i * kPeriod, 3));
  REQUIRE(way.stretches().size() == 1);
  const ToolWay::Stretch& stretch = way.stretches().front();
  CHECK(stretch.line == 3);
  double worst = 0;
  for (double turn = 0; turn <= kTurn * periods * kPeriod; turn += 1e-4)
    worst =
        std::max(worst, distance(kRadius * Vector3d(std::cos(turn), std::sin(turn), 0), stretch));
  CHECK(worst <= ToolWay::kMiss);
  // The sagitta of a chord of the length 2 sqrt(2 r s) is s: with s = 2 um 220 of them.
  CHECK(stretch.corners.size() < 300);
}

TEST_CASE("a straight way is few points, and another line or a rest begins a new stretch") {
  const auto robot = rob::motion::embedded_robot("gantry");
  ToolWay way(robot);
  double time = 0;
  double x = 0;
  const auto go = [&](int periods, double step, int line) {
    for (int i = 0; i < periods; ++i) way.take(on_line(time += kPeriod, x += step, line));
  };
  go(20, 0.001, 1);
  go(20, 0.001, 2);
  go(5, 0, 2);
  go(20, 0.001, 2);
  REQUIRE(way.stretches().size() == 3);
  CHECK(way.stretches()[0].line == 1);
  CHECK(way.stretches()[1].line == 2);
  CHECK(way.stretches()[2].line == 2);
  for (const ToolWay::Stretch& stretch : way.stretches()) CHECK(stretch.corners.size() == 2);
  // The first reference is where the robot stands: 19 steps of line 1, 20 of line 2.
  CHECK(way.stretches()[0].corners.back().x() == doctest::Approx(0.020));
  CHECK(way.stretches()[1].corners.front() == way.stretches()[0].corners.back());
  CHECK(way.stretches()[2].begins == doctest::Approx(0.45));
  CHECK(way.at(0.05).x() == doctest::Approx(0.001));
  CHECK(way.at(9).x() == doctest::Approx(0.060));
}
