#include "tests/support/path_deviation.h"

#include <doctest/doctest.h>

#include <numbers>

#include "tests/support/made_trace.h"

using Eigen::Vector3d;
using rob::test::AxisState;
using rob::test::made_trace;
using rob::test::path_deviation;
using rob::test::path_excess;
using rob::test::PathBounds;
using rob::test::PathDeviation;
using rob::test::ProgrammedPath;
using rob::test::tool_curve;

namespace {

constexpr double kV = 100, kA = 1000;  // mm/s, mm/s²

/// Along x into (0, 0), then along y, at 100 mm/s: both axes change their speed at 1000 mm/s²
/// within 0.1 s, so 5 mm of each leg are left out. The corner begins at t = 0.1.
AxisState parabolic_corner(double t) {
  const double b = std::clamp(t - 0.1, 0.0, kV / kA), after = std::max(t - 0.1 - kV / kA, 0.0);
  const bool turning = b > 0 && after == 0;
  return {{-5 - kV * std::max(0.1 - t, 0.0) + kV * b - kA * b * b / 2, kA * b * b / 2 + kV * after},
          {kV - kA * b, kA * b},
          {turning ? -kA : 0, turning ? kA : 0}};
}

/// 100 mm/s along the given places, corners at full speed.
AxisState along(const std::vector<Vector3d>& places, double t) {
  double left = kV * t;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Vector3d way = places[i] - places[i - 1];
    if (left > way.norm() && i + 1 < places.size()) {
      left -= way.norm();
      continue;
    }
    const Vector3d p = places[i - 1] + std::min(left / way.norm(), 1.0) * way;
    const Vector3d v = kV * way.normalized();
    return {{p.x(), p.y()}, {v.x(), v.y()}, {0, 0}};
  }
  return {};
}

}  // namespace

TEST_CASE("a corner that is cut by a parabola misses its point by Δv²/8A") {
  const auto curve = tool_curve(made_trace(0.3, 0.001, parabolic_corner), 2);
  const PathDeviation found = path_deviation(curve, {{{-15, 0, 0}, {0, 0, 0}, {0, 15, 0}}}, 20);
  // Δv = 100·√2 mm/s and |a| = 1000·√2 mm/s²; in mid-corner each axis is 1.25 mm off its leg.
  CHECK(found.miss == doctest::Approx(1.25 * std::numbers::sqrt2).epsilon(1e-6));
  CHECK(found.from_path == doctest::Approx(1.25).epsilon(1e-6));
  CHECK(found.greatest() == found.miss);
}

TEST_CASE("a line beside the programmed one is as far from it everywhere") {
  const auto shifted = [](double t) { return AxisState{{kV * t, 0.05}, {kV, 0}, {0, 0}}; };
  const auto curve = tool_curve(made_trace(1, 0.001, shifted), 2);
  const PathDeviation found = path_deviation(curve, {{{0, 0, 0}, {50, 0, 0}, {100, 0, 0}}}, 3);
  CHECK(found.from_path == doctest::Approx(0.05).epsilon(1e-9));
  CHECK(found.miss == doctest::Approx(0.05).epsilon(1e-9));
}

TEST_CASE("only programmed points can be missed, not the places of a curve's chords") {
  const auto line = [](double t) { return AxisState{{kV * t, 0}, {kV, 0}, {0, 0}}; };
  const auto curve = tool_curve(made_trace(1, 0.001, line), 2);
  const std::vector<Vector3d> bent = {{0, 0, 0}, {50, 0.4, 0}, {100, 0, 0}};
  CHECK(path_deviation(curve, {bent}, 3).miss == doctest::Approx(0.4));
  CHECK(path_deviation(curve, {bent, {0, 2}}, 3).miss < 1e-9);
}

TEST_CASE("between rows the curve is a cubic: rows 2 mm apart on a circle of 50 mm suffice") {
  constexpr double kRadius = 50, kRate = kV / kRadius;
  const auto circle = [](double t) {
    const double c = std::cos(kRate * t), s = std::sin(kRate * t);
    return AxisState{{kRadius * c, kRadius * s}, {-kV * s, kV * c}, {0, 0}};
  };
  ProgrammedPath path;
  for (int k = 0; k <= 10000; ++k) {
    const double angle = 2 * std::numbers::pi * k / 10000;
    path.places.emplace_back(kRadius * std::cos(angle), kRadius * std::sin(angle), 0);
  }
  const auto curve = tool_curve(made_trace(3.14, 0.02, circle), 2);
  // A chord of 2 mm would be 2²/(8·50) = 0.01 mm off.
  CHECK(path_deviation(curve, path, 5).from_path < 2e-4);
}

TEST_CASE("a line of a hatch that is left out is found, though its neighbours are 1 mm away") {
  const std::vector<Vector3d> hatch = {{0, 0, 0}, {50, 0, 0}, {50, 1, 0}, {1e-9, 1, 1e-9},
                                       {0, 2, 0}, {50, 2, 0}, {50, 3, 0}, {0, 3, 0}};
  const auto followed = [&](double t) { return along(hatch, t); };
  const auto good = tool_curve(made_trace(2.05, 0.001, followed), 2, 1);
  CHECK(path_deviation(good, {hatch}, 3).greatest() < 0.11);  // rows are 0.1 mm apart
  std::vector<Vector3d> short_cut = hatch;
  short_cut.erase(short_cut.begin() + 2, short_cut.begin() + 6);  // straight from line 1 to line 4
  const auto cut = [&](double t) { return along(short_cut, t); };
  const auto bad = tool_curve(made_trace(1.03, 0.001, cut), 2, 1);
  CHECK(path_deviation(bad, {hatch}, 3).greatest() > 10);
}

TEST_CASE("a spike of 180 degrees is followed to its tip") {
  const std::vector<Vector3d> spike = {{0, 0, 0}, {20, 0, 0}, {0, 0, 0}};
  const auto whole = [&](double t) { return along(spike, t); };
  CHECK(path_deviation(tool_curve(made_trace(0.4, 0.001, whole), 2), {spike}, 3).miss < 1e-9);
  const std::vector<Vector3d> stunted = {{0, 0, 0}, {19.5, 0, 0}, {0, 0, 0}};
  const auto early = [&](double t) { return along(stunted, t); };
  const auto found = path_deviation(tool_curve(made_trace(0.39, 0.001, early), 2), {spike}, 3);
  CHECK(found.miss == doctest::Approx(0.5).epsilon(0.01));
  CHECK(found.from_path < 0.02);  // the cubic through the turned speed overshoots a little
}

TEST_CASE("each point has its own bound, and the path between two of them the greater") {
  const auto curve = tool_curve(made_trace(0.3, 0.001, parabolic_corner), 2);
  const ProgrammedPath path{{{-15, 0, 0}, {0, 0, 0}, {0, 15, 0}}};
  CHECK(path_excess(curve, path, PathBounds{{1e-9, 1.77, 1e-9}}, 20).miss <= 0);  // 1.25·√2 = 1.768
  CHECK(path_excess(curve, path, PathBounds{{1e-9, 1.77, 1e-9}}, 20).from_path <= 1e-9);
  const auto tight = path_excess(curve, path, PathBounds{{1e-9, 1, 1e-9}}, 20);
  CHECK(tight.miss == doctest::Approx(1.25 * std::numbers::sqrt2 - 1).epsilon(1e-6));
  CHECK(tight.from_path == doctest::Approx(0.25).epsilon(1e-6));
  CHECK(tight.point == 1);
}

TEST_CASE("near another part of the path a tool still has what is allowed of its own") {
  // There, 5 mm aside, and back: 2 mm beside the way out is 3 mm beside the way back.
  const std::vector<Vector3d> path = {{0, 0, 0}, {20, 0, 0}, {20, 5, 0}, {0, 5, 0}};
  const std::vector<Vector3d> beside = {{0, 0, 0},  {5, 3, 0},  {15, 3, 0},
                                        {20, 0, 0}, {20, 5, 0}, {0, 5, 0}};
  const PathBounds bounds{{1e-9, 1e-9, 1e-9, 1e-9}, {0, 3, 0, 0}};
  CHECK(path_excess(beside, {path}, bounds, 60).from_path <= 1e-9);
  const PathBounds tight{{1e-9, 1e-9, 1e-9, 1e-9}, {0, 0, 0, 0}};
  CHECK(path_excess(beside, {path}, tight, 60).from_path == doctest::Approx(2));
}
