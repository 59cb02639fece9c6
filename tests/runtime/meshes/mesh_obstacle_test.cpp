// Convex hulls as obstacles, against the closed form of a box.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/split_mix.h"
#include "motion/collision/distance.h"
#include "motion/space/rotation.h"
#include "runtime/meshes/mesh_obstacle.h"

using Eigen::Vector3d;
using namespace rob::motion;
using rob::runtime::convex_body;
using rob::runtime::convex_hull;

namespace {

std::vector<Vector3d> corners_of_box(const Box& box) {
  std::vector<Vector3d> corners;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0})
        corners.push_back(place_of(box.half.cwiseProduct(Vector3d(x, y, z)), box.centre));
  return corners;
}

}  // namespace

TEST_CASE("the distance to a hull is that of the box which it is, and 0.1 mm less") {
  rob::SplitMix random(20);
  const auto within = [&](double low, double high) { return low + (high - low) * random.share(); };
  const auto place = [&](double far) {
    return Vector3d(within(-far, far), within(-far, far), within(-far, far));
  };
  int apart = 0;
  int touching = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(within(-1, 1), within(-1, 1), within(-1, 1), within(-1, 1)).normalized();
    const Box box{{place(0.2), turn}, {within(0.01, 0.2), within(0.01, 0.2), within(0.01, 0.2)}};
    const auto body = convex_body(convex_hull(corners_of_box(box)));
    Capsule capsule{place(0.4), place(0.4), within(0.005, 0.05)};
    if (i % 5 == 0) capsule.to = capsule.from;
    const double exact = distance(capsule, box);
    const double found = body->distance(capsule);
    CAPTURE(i);
    CAPTURE(exact);
    if (exact > 0.2e-3) {
      ++apart;
      // From afar it may be less; never more, which would hide a contact.
      CHECK(found <= exact);
      if (found < 0.04) CHECK(found == doctest::Approx(exact - 0.1e-3).epsilon(1e-3));
    } else if (exact < -0.2e-3) {
      ++touching;
      CHECK(found <= 0);
    }
  }
  CHECK(apart > 500);
  CHECK(touching > 300);
}

TEST_CASE("deeper in a hull is less") {
  const Box box{{Vector3d::Zero(), Eigen::Quaterniond::Identity()}, {0.1, 0.1, 0.1}};
  const auto body = convex_body(convex_hull(corners_of_box(box)));
  const auto at = [&](double x) { return body->distance({{x, 0, 0}, {x, 0, 0.02}, 0.01}); };
  // From the face at 100 mm inwards, and the radius.
  CHECK(at(0.09) == doctest::Approx(-0.02));
  CHECK(at(0.08) == doctest::Approx(-0.03));
  CHECK(at(0.07) < at(0.08));
}

TEST_CASE("a flat mesh is an obstacle, too") {
  const auto body = convex_body(
      convex_hull({{0, 0, 0}, {0.2, 0, 0}, {0, 0.2, 0}, {0.2, 0.2, 0}, {0.1, 0.05, 0}}));
  CHECK(body->distance({{0.1, 0.1, 0.03}, {0.1, 0.1, 0.5}, 0.01}) ==
        doctest::Approx(0.02 - 0.1e-3).epsilon(0.01));
  CHECK(body->distance({{0.1, 0.1, -0.03}, {0.1, 0.1, 0.5}, 0.01}) <= 0);
}
