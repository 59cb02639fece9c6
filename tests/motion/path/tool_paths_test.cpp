#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include "motion/path/euler_line.h"
#include "motion/path/joint_spline.h"
#include "motion/path/tool_arc.h"
#include "motion/path/tool_line.h"
#include "motion/path/tool_spiral.h"
#include "motion/path/tool_spline.h"
#include "motion/robots/robot_library.h"
#include "motion/space/rotation.h"
#include "tests/support/degrees.h"

using namespace rob::motion;
using Eigen::Vector3d;
using rob::test::kDegree;

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

/// 3 m/s along x and 2 rad/s about z, for s from −1 to 1.
class EvenPath : public ToolPath {
 public:
  Pose at(double s) const noexcept override { return pose(3 * s, 0, 0, Vector3d(0, 0, 2 * s)); }
  double begin() const noexcept override { return -1; }
  double end() const noexcept override { return 1; }
  double way() const noexcept override { return 6; }
  double turn() const noexcept override { return 4; }
};

double off(const Pose& a, const Pose& b) {
  return (a.position - b.position).norm() + rotation_between(a.orientation, b.orientation).norm();
}

}  // namespace

TEST_CASE("speeds and shares of a path are those between its ends, wherever they are") {
  const EvenPath path;
  CHECK(path.greatest_speed() == doctest::Approx(3));
  CHECK(path.greatest_turning() == doctest::Approx(2));
  for (const double s : {-0.9, 0.0, 0.5}) {
    CAPTURE(s);
    const ToolSpeed speed = speed_at(path, s);
    CHECK(speed.way == doctest::Approx(3).epsilon(1e-9));
    CHECK(speed.turn == doctest::Approx(2).epsilon(1e-9));
    CHECK(path.share_at(s) == doctest::Approx((s + 1) / 2));
    CHECK(path.at_share((s + 1) / 2) == doctest::Approx(s));
    CHECK(parameter_of(path, (s + 1) / 2) == doctest::Approx(s));
  }
}

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

namespace {

JointVector in_degrees(std::initializer_list<double> values) {
  JointVector q(static_cast<Eigen::Index>(values.size()));
  Eigen::Index i = 0;
  for (const double value : values) q[i++] = value * kDegree;
  return q;
}

const rob::motion::RobotModel& splined() {
  static const auto robot = rob::motion::embedded_robot("irb120");
  return robot;
}

const std::vector<JointVector>& through_joints() {
  static const std::vector<JointVector> through{
      in_degrees({0, 0, 0, 0, 0, 0}), in_degrees({40, 10, -20, 0, 30, 0}),
      in_degrees({-20, 30, 10, 60, -30, 90}), in_degrees({-60, 0, 0, 60, 45, -90})};
  return through;
}

}  // namespace

TEST_CASE("a joint spline passes through its points, and its first two derivatives do not jump") {
  const auto spline = JointSpline::through(splined(), {}, through_joints());
  REQUIRE(spline);
  const JointPath& axes = *spline->axes();
  std::size_t met = 0;
  for (std::size_t i = 0; i < axes.nodes().size(); ++i) {
    const JointPath::Node& node = axes.nodes()[i];
    if (met < through_joints().size() && (node.q - through_joints()[met]).norm() < 1e-12) ++met;
    if (i == 0) continue;
    // A piece turns no axis by more than 5 deg.
    CHECK((node.q - axes.nodes()[i - 1].q).cwiseAbs().maxCoeff() < 5.001 * kDegree);
    // Beside the node, on either side: cubic, so that the second derivative is linear in between.
    constexpr double kBeside = 1e-7;
    const PathPoint before = axes.at(node.time - kBeside);
    CHECK((before.qd - node.qd).norm() < 1e-4 * (1 + node.qd.norm()));
    CHECK((before.qdd - node.qdd).norm() < 1e-4 * (1 + node.qdd.norm()));
  }
  CHECK(met == through_joints().size());
  CHECK(axes.nodes().front().qdd.norm() < 1e-12);
  CHECK(axes.nodes().back().qdd.norm() < 1e-9);
}

TEST_CASE("with three points as far apart it is the natural cubic spline of the textbooks") {
  // M1 = 3/2·(y0 − 2·y1 + y2)/h², so half way to the middle y = (y0 + y1)/2 − M1·h²/16.
  const std::vector<JointVector> through{in_degrees({0, 0, 0, 0, 0, 0}),
                                         in_degrees({30, 9, 0, 0, 0, 0}),
                                         in_degrees({0, 3, 0, 0, 0, 0})};
  const auto spline = JointSpline::through(splined(), {}, through);
  REQUIRE(spline);
  const JointVector second = through[0] - 2 * through[1] + through[2];
  const JointVector wanted = (through[0] + through[1]) / 2 - second * (3.0 / 32);
  CHECK((spline->axes()->at(0.25).q - wanted).norm() < 1e-12);
  CHECK((spline->axes()->at(0.5).q - through[1]).norm() < 1e-12);
  CHECK(spline->first_point() == doctest::Approx(0.5));
  CHECK(spline->last_point() == doctest::Approx(0.5));
}

TEST_CASE("the parameter goes with the time of the slowest axis") {
  // Axis 6 is faster than axis 1: 420 and 250 deg/s.
  const auto spline =
      JointSpline::through(splined(), {},
                           {in_degrees({0, 0, 0, 0, 0, 0}), in_degrees({25, 0, 0, 0, 0, 0}),
                            in_degrees({25, 0, 0, 0, 0, 84})});
  REQUIRE(spline);
  CHECK(spline->first_point() == doctest::Approx(1.0 / 3));
}

TEST_CASE("it measures the way of the tip of its tool, and what the axis turns that turns most") {
  Pose tip;
  tip.position = {0.03, 0, 0.1};
  const auto spline = JointSpline::through(splined(), tip, through_joints());
  REQUIRE(spline);
  double way = 0;
  double turn = 0;
  constexpr int kParts = 200'000;
  Eigen::Vector3d before = spline->at(0).position;
  JointVector last = spline->axes()->at(0).q;
  JointVector turns = JointVector::Zero(6);
  for (int i = 1; i <= kParts; ++i) {
    const double s = static_cast<double>(i) / kParts;
    const JointVector q = spline->axes()->at(s).q;
    const Eigen::Vector3d place = place_of(tip.position, splined().kinematics->forward(q));
    way += (place - before).norm();
    turns += (q - last).cwiseAbs();
    before = place;
    last = q;
  }
  turn = turns.maxCoeff();
  CHECK(spline->way() == doctest::Approx(way).epsilon(1e-5));
  CHECK(spline->turn() == doctest::Approx(turn).epsilon(1e-5));
  CHECK(spline->share_at(spline->at_share(0.3)) == doctest::Approx(0.3));
}

TEST_CASE("there is none through one point twice") {
  CHECK_FALSE(JointSpline::through(
      splined(), {}, {through_joints()[0], through_joints()[1], through_joints()[1]}));
}

using EulerTrouble = rob::motion::EulerLine::Trouble;

namespace {

Pose turned_at(double x, double a, double b, double c) {
  return {{x, 0, 0}, rob::motion::orientation_from({a * kDegree, b * kDegree, c * kDegree})};
}

std::optional<EulerLine> euler_between(const Pose& from, const Pose& to) {
  const auto made = EulerLine::between(from, to);
  if (!std::holds_alternative<EulerLine>(made)) return std::nullopt;
  return std::get<EulerLine>(made);
}

std::optional<EulerTrouble> euler_trouble(const Pose& from, const Pose& to) {
  const auto made = EulerLine::between(from, to);
  if (std::holds_alternative<EulerLine>(made)) return std::nullopt;
  return std::get<EulerTrouble>(made);
}

}  // namespace

TEST_CASE("along an Euler line place and angles change evenly") {
  const auto path = euler_between(turned_at(0, 170, -60, 10), turned_at(0.4, -150, 70, 130));
  REQUIRE(path);
  for (const double s : {0.0, 0.1, 0.35, 0.5, 0.9, 1.0}) {
    CAPTURE(s);
    const FixedAngles angles = fixed_angles(path->at(s).orientation);
    // a goes the shorter way, over 180 deg.
    CHECK(std::remainder(angles.a - (170 + s * 40) * kDegree, 2 * std::numbers::pi) ==
          doctest::Approx(0).epsilon(1e-9));
    CHECK(angles.b == doctest::Approx((-60 + s * 130) * kDegree));
    CHECK(angles.c == doctest::Approx((10 + s * 120) * kDegree));
    CHECK(path->at(s).position.x() == doctest::Approx(0.4 * s));
  }
  CHECK(path->way() == doctest::Approx(0.4));
}

TEST_CASE("the turning of an Euler line is what its orientations turn") {
  const auto path = euler_between(turned_at(0, 20, -60, 10), turned_at(0.4, -30, 70, 130));
  REQUIRE(path);
  double turn = 0;
  double greatest = 0;
  constexpr int kParts = 20'000;
  for (int i = 0; i < kParts; ++i) {
    const double s = static_cast<double>(i) / kParts;
    const double step = rob::motion::rotation_between(path->at(s).orientation,
                                                      path->at(s + 1.0 / kParts).orientation)
                            .norm();
    turn += step;
    greatest = std::max(greatest, step * kParts);
  }
  CHECK(path->turn() == doctest::Approx(turn).epsilon(1e-6));
  CHECK(path->greatest_turning() == doctest::Approx(greatest).epsilon(1e-3));
}

TEST_CASE("an Euler line with b near 90 deg, or half a turn of an angle, is none") {
  CHECK(euler_trouble(turned_at(0, 0, 89.5, 0), turned_at(1, 0, 0, 0)) ==
        EulerTrouble::SteepBeginning);
  CHECK(euler_trouble(turned_at(0, 0, 0, 0), turned_at(1, 0, -89.1, 0)) == EulerTrouble::SteepEnd);
  CHECK_FALSE(euler_trouble(turned_at(0, 0, -88.9, 0), turned_at(1, 0, 88.9, 0)));
  CHECK(euler_trouble(turned_at(0, 0, 0, 0), turned_at(1, 0, 0, 180)) == EulerTrouble::HalfTurn);
  CHECK_FALSE(euler_trouble(turned_at(0, 0, 0, 0), turned_at(1, 0, 0, 179)));
}
