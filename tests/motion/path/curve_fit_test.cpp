#include "motion/path/curve_fit.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>
#include <vector>

namespace rob::test {

namespace {

using Eigen::Vector3d;
using motion::CurveFit;

/// A polyline and its curve, read as it is settled.
struct FittedCurve {
  std::vector<Vector3d> vertices;
  std::vector<Vector3d> at_vertices;  ///< the curve at the u of each vertex
  std::vector<CurveFit::Place> places;
  std::vector<double> us;  ///< of the places
  bool in_order = true;    ///< the u of the vertices rise
  double worst = 0;
  int doubled = 0;
};

/// Takes all that is settled of a fit.
void read_settled(CurveFit& fit, FittedCurve& curve) {
  while (fit.ready()) {
    const double settled = fit.settle();
    while (curve.at_vertices.size() < curve.vertices.size()) {
      const std::size_t next = curve.at_vertices.size();
      const double u = fit.at_vertex(next);
      if (!(u <= settled)) break;
      if (next > 0 && u < fit.at_vertex(next - 1)) curve.in_order = false;
      curve.at_vertices.push_back(fit.at(u).place);
    }
    for (double u = curve.us.empty() ? 0 : curve.us.back() + 0.125; u <= settled; u += 0.125) {
      curve.us.push_back(u);
      curve.places.push_back(fit.at(u));
    }
    fit.drop(settled);
    if (!curve.at_vertices.empty()) fit.drop_vertices(curve.at_vertices.size() - 1);
  }
}

FittedCurve fitted(const std::vector<Vector3d>& vertices, double tolerance, double knot) {
  CurveFit fit(knot, 1);
  FittedCurve curve;
  curve.vertices = vertices;
  fit.begin(vertices.front());
  for (std::size_t i = 1; i < vertices.size(); ++i) {
    fit.append(vertices[i], tolerance);
    read_settled(fit, curve);
  }
  fit.end();
  read_settled(fit, curve);
  curve.worst = fit.worst();
  curve.doubled = fit.doubled();
  CHECK(fit.ended());
  return curve;
}

double greatest_miss(const FittedCurve& curve) {
  double most = 0;
  for (std::size_t i = 0; i < curve.at_vertices.size(); ++i)
    most = std::max(most, (curve.at_vertices[i] - curve.vertices[i]).norm());
  return most;
}

}  // namespace

TEST_CASE("a circle of short chords becomes a circle: its curve has their radius") {
  constexpr double kRadius = 0.05;
  std::vector<Vector3d> chords;
  for (int i = 0; i <= 2000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 2000;
    chords.emplace_back(kRadius * std::cos(angle), kRadius * std::sin(angle), 0);
  }
  const FittedCurve curve = fitted(chords, 1e-4, 2.5e-4);
  REQUIRE(curve.at_vertices.size() == chords.size());
  CHECK(greatest_miss(curve) <= 1e-4);
  CHECK((curve.at_vertices.front() - chords.front()).norm() < 1e-15);
  CHECK((curve.at_vertices.back() - chords.back()).norm() < 1e-15);
  for (std::size_t i = 80; i + 80 < curve.places.size(); ++i) {
    const CurveFit::Place& place = curve.places[i];
    const double curvature =
        place.first.cross(place.second).norm() / std::pow(place.first.norm(), 3);
    CHECK(curvature * kRadius == doctest::Approx(1).epsilon(0.1));
  }
}

TEST_CASE("noise within the tolerance is left out: a straight line stays nearly straight") {
  std::vector<Vector3d> noisy;
  for (int i = 0; i <= 2000; ++i)
    noisy.emplace_back(5e-5 * i, 2e-6 * ((i * 7919) % 21 - 10) / 10.0, 0);
  const FittedCurve curve = fitted(noisy, 1e-5, 5e-5);
  CHECK(greatest_miss(curve) <= 1e-5);
  double bend = 0;
  for (std::size_t i = 200; i + 200 < curve.places.size(); ++i)
    bend = std::max(bend, curve.places[i].second.norm() / curve.places[i].first.squaredNorm());
  // 1/m: 1 m/s² at 0.1 m/s. The chords turn by up to 0.08 rad in 0.05 mm, which is 1600.
  CHECK(bend < 100);
}

TEST_CASE("lines that lie closer than the tolerance are all run along, in their order") {
  std::vector<Vector3d> hatch;
  for (int line = 0; line < 10; ++line) {
    const double y = 5e-5 * line;  // half of the tolerance apart
    hatch.emplace_back(line % 2 == 0 ? 0 : 0.005, y, 0);
    hatch.emplace_back(line % 2 == 0 ? 0.005 : 0, y, 0);
  }
  const FittedCurve curve = fitted(hatch, 1e-4, 2.5e-4);
  CHECK(curve.in_order);
  REQUIRE(curve.at_vertices.size() == hatch.size());
  CHECK(greatest_miss(curve) <= 1e-4);
}

TEST_CASE("a sharp corner among short legs is kept within the tolerance by closer knots") {
  std::vector<Vector3d> legs;
  for (int i = 0; i <= 40; ++i) legs.emplace_back(1e-4 * i, 0, 0);
  for (int i = 1; i <= 40; ++i) legs.emplace_back(4e-3 - 1e-4 * i, 1e-4 * i, 0);
  const FittedCurve curve = fitted(legs, 1e-5, 2.5e-4);
  CHECK(curve.doubled > 0);
  CHECK(curve.worst <= 0.95);
  CHECK(greatest_miss(curve) <= 1e-5);
}

TEST_CASE("where no number of knots is enough, it ends and says by how much it misses") {
  // A corner near each end whose tolerance no sum of doubles can keep.
  for (const int corner : {3, 20, 37}) {
    CAPTURE(corner);
    CurveFit fit(2.5e-4, 1);
    fit.begin(Vector3d::Zero());
    for (int i = 1; i <= 40; ++i) {
      const double along = 1e-4 * std::min(i, corner);
      fit.append(Vector3d(along, 1e-4 * std::max(0, i - corner), 0), i == corner ? 1e-22 : 1e-5);
    }
    fit.end();
    int windows = 0;
    while (fit.ready() && ++windows < 1000) fit.settle();
    CHECK(fit.ended());
    CHECK(fit.worst() > 1);
    CHECK((fit.at(fit.length()).place - Vector3d(1e-4 * corner, 1e-4 * (40 - corner), 0)).norm() <
          1e-12);
  }
}

TEST_CASE("it joins straight lines at both ends with continuous second derivatives") {
  CurveFit fit(2.5e-4, 1);
  const Vector3d before = Vector3d(1, 2, 0.5).normalized();
  const Vector3d after = Vector3d(1, -1, 0).normalized();
  const Vector3d corner(0.01, 0.02, 0.03);
  const double lead = 3.5 * 2.5e-4;
  fit.begin_straight(corner - lead * before, before);
  fit.append(corner, 1e-4);
  fit.append(corner + Vector3d(5e-4, 0, 0), 1e-4);
  const double way = fit.end_straight(after);
  CHECK(way >= 3 * 2.5e-4 * (1 - 1e-9));
  CHECK(way <= 4 * 2.5e-4 * (1 + 1e-9));
  while (fit.ready()) fit.settle();
  REQUIRE(fit.ended());
  const CurveFit::Place begin = fit.at(0);
  const CurveFit::Place end = fit.at(fit.length());
  CHECK((begin.place - (corner - lead * before)).norm() < 1e-15);
  CHECK((begin.first - 2.5e-4 * before).norm() < 1e-15);
  CHECK(begin.second.norm() < 1e-15);
  CHECK((end.place - (corner + Vector3d(5e-4, 0, 0) + way * after)).norm() < 1e-15);
  CHECK((end.first - 2.5e-4 * after).norm() < 1e-15);
  CHECK(end.second.norm() < 1e-15);
  CHECK(fit.worst() <= 0.95);
}

}  // namespace rob::test
