#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "motion/path/tool_arc.h"
#include "motion/path/tool_line.h"
#include "motion/path/tool_spiral.h"
#include "motion/path/tool_spline.h"
#include "motion/space/rotation.h"

using namespace rob::motion;
using Eigen::Vector3d;

namespace {

Pose pose(double x, double y, double z, const Vector3d& turned = Vector3d::Zero()) {
  return {Vector3d(x, y, z), rotation_by(turned)};
}

/// The length of the curve's chords.
double measured_way(const ToolPath& path, double to = 1) {
  double way = 0;
  constexpr int kChords = 20000;
  for (int i = 0; i < kChords; ++i)
    way += (path.at(to * (i + 1) / kChords).position - path.at(to * i / kChords).position).norm();
  return way;
}

Vector3d velocity(const ToolPath& path, double s) {
  constexpr double kStep = 1e-6;
  return (path.at(s + kStep).position - path.at(s - kStep).position) / (2 * kStep);
}

Vector3d bend(const ToolPath& path, double s, double side) {
  constexpr double kStep = 1e-4;
  const double at = s + side * 2 * kStep;
  return (path.at(at + kStep).position - 2 * path.at(at).position + path.at(at - kStep).position) /
         (kStep * kStep);
}

double off(const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() + rotation_between(a.orientation, b.orientation).norm();
}

}  // namespace

TEST_CASE("a rotation vector is the rotation that it came from") {
  for (const double angle : {0.0, 1e-12, 1e-5, 1.0, 3.0, std::numbers::pi - 1e-9}) {
    const Vector3d v = angle * Vector3d(1, -2, 2) / 3;
    CHECK((rotation_vector(rotation_by(v)) - v).norm() < 1e-14);
  }
  // The shorter way round, whatever the quaternion's sign.
  const Vector3d back = rotation_vector(rotation_by(Vector3d(0, 0, 1.5 * std::numbers::pi)));
  CHECK((back - Vector3d(0, 0, -0.5 * std::numbers::pi)).norm() < 1e-14);
}

TEST_CASE("a line runs evenly, and turns evenly by the shortest rotation") {
  const auto line = ToolLine::between(pose(0, 0, 0), pose(0.3, 0, 0.4, Vector3d(0, 0, 1)));
  REQUIRE(line.has_value());
  CHECK(line->way() == doctest::Approx(0.5));
  CHECK(line->turn() == doctest::Approx(1));
  CHECK(off(line->at(0.25), pose(0.075, 0, 0.1, Vector3d(0, 0, 0.25))) < 1e-15);
  CHECK_FALSE(ToolLine::between(pose(0, 0, 0), pose(1, 0, 0, Vector3d(std::numbers::pi, 0, 0)))
                  .has_value());
}

TEST_CASE("an arc lies on the circle through its three points, evenly") {
  // Around (1, 2, 3) with radius 2 in the plane z = 3: from 0° through 90° to 200°.
  const auto at = [](double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return pose(1 + 2 * std::cos(angle), 2 + 2 * std::sin(angle), 3);
  };
  const auto arc = ToolArc::through(at(0), at(90).position, at(200));
  REQUIRE(arc.has_value());
  CHECK(arc->way() == doctest::Approx(2 * 200 * std::numbers::pi / 180));
  for (int i = 0; i <= 10; ++i) CHECK(off(arc->at(i / 10.0), at(20.0 * i)) < 1e-14);
  // The other way round through the other side.
  const auto other = ToolArc::through(at(0), at(-90).position, at(200));
  REQUIRE(other.has_value());
  CHECK(other->way() == doctest::Approx(2 * 160 * std::numbers::pi / 180));
  CHECK(off(other->at(0.5), at(-80)) < 1e-14);
}

TEST_CASE("no arc leads through points on a line, or through two that are one") {
  CHECK_FALSE(ToolArc::through(pose(0, 0, 0), Vector3d(1, 1, 0), pose(2, 2, 0)).has_value());
  CHECK_FALSE(ToolArc::through(pose(0, 0, 0), Vector3d(1, 1, 0), pose(0, 0, 0)).has_value());
  CHECK_FALSE(ToolArc::through(pose(0, 0, 0), Vector3d(0, 0, 0), pose(1, 0, 0)).has_value());
  CHECK_FALSE(ToolArc::through(pose(0, 0, 0), Vector3d(1, 0, 0), pose(1, 0, 0)).has_value());
}

TEST_CASE("a spline passes exactly through its points, without a jump in its second derivative") {
  const std::vector<Pose> points{pose(0, 0, 0), pose(0.1, 0.05, 0, Vector3d(0, 0, 1)),
                                 pose(0.2, 0, 0.1, Vector3d(0.5, 0, 1)), pose(0.25, 0.2, 0)};
  const auto spline = ToolSpline::through(points);
  REQUIRE(spline.has_value());
  double whole = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
    whole += (points[i].position - points[i - 1].position).norm();
  double knot = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) knot += (points[i].position - points[i - 1].position).norm() / whole;
    CAPTURE(i);
    CHECK(off(spline->at(knot), points[i]) < 1e-14);
    if (i == 0 || i + 1 == points.size()) continue;
    // h = 1e-4 on either side: the bend changes by its slope times 4e-4, and rounding is 1e-8.
    CHECK((bend(*spline, knot, 1) - bend(*spline, knot, -1)).norm() < 2e-2);
  }
  CHECK(bend(*spline, 0, 1).norm() < 2e-2);  // natural ends
  CHECK(spline->way() == doctest::Approx(measured_way(*spline)).epsilon(1e-5));
  CHECK(spline->share_at(0.4) ==
        doctest::Approx(measured_way(*spline, 0.4) / spline->way()).epsilon(1e-5));
  CHECK(spline->at_share(spline->share_at(0.4)) == doctest::Approx(0.4).epsilon(1e-9));
  for (int i = 1; i < 100; ++i)
    CHECK(velocity(*spline, i / 100.0).norm() <= spline->greatest_speed() * (1 + 1e-4));
}

TEST_CASE("a spline through two points is the line between them") {
  const std::vector<Pose> points{pose(0, 0, 0), pose(0.1, 0.2, 0.3, Vector3d(0, 1, 0))};
  const auto spline = ToolSpline::through(points);
  const auto line = ToolLine::between(points[0], points[1]);
  REQUIRE((spline && line));
  for (int i = 0; i <= 8; ++i) CHECK(off(spline->at(i / 8.0), line->at(i / 8.0)) < 1e-14);
  CHECK_FALSE(ToolSpline::through({points[0], points[1], points[1]}).has_value());
}

TEST_CASE("a spline may turn farther than half a turn in all") {
  std::vector<Pose> points;
  for (int i = 0; i < 6; ++i) points.push_back(pose(0.1 * i, 0, 0, Vector3d(0, 0, i)));
  const auto spline = ToolSpline::through(points);
  REQUIRE(spline.has_value());
  CHECK(spline->turn() == doctest::Approx(5));
  CHECK(off(spline->at(0.9), pose(0.45, 0, 0, Vector3d(0, 0, 4.5))) < 1e-12);
}

// S4: from −r in x through +y; each turn is 2πr at first, and the speed shrinks with the radius.
TEST_CASE("a spiral runs inwards around a centre that lies its radius along the frame's x") {
  const Pose down = pose(0.4, 0.1, 0.2, Vector3d(std::numbers::pi, 0, 0));  // the tool points down
  const auto spiral = ToolSpiral::inwards(down, Eigen::Quaterniond::Identity(), 0.004, 5);
  REQUIRE(spiral.has_value());
  CHECK(off(spiral->at(0), down) < 1e-15);
  CHECK((spiral->at(1).position - Vector3d(0.404, 0.1, 0.2)).norm() < 1e-15);
  // A quarter of the first turn: at +y, with a twentieth of the radius gone.
  CHECK((spiral->at(0.05).position - Vector3d(0.404, 0.1 + 0.95 * 0.004, 0.2)).norm() < 1e-15);
  CHECK(spiral->greatest_speed() == doctest::Approx(2 * std::numbers::pi * 0.004 * 5));
  CHECK(spiral->way() == doctest::Approx(measured_way(*spiral)).epsilon(1e-6));
  CHECK(spiral->share_at(0.3) ==
        doctest::Approx(measured_way(*spiral, 0.3) / spiral->way()).epsilon(1e-6));
  const Eigen::Quaterniond upright =
      rotation_by(Vector3d(0, -std::numbers::pi / 2, 0));  // x along z
  CHECK_FALSE(ToolSpiral::inwards(down, upright, 0.004, 5).has_value());
}
