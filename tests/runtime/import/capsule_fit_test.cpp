// Capsules hold all of what they are fitted to, and stand out as far as geometry says.

#include "runtime/import/capsule_fit.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <fstream>
#include <random>

#include "motion/collision/distance.h"
#include "motion/robots/robot_file_error.h"
#include "runtime/meshes/mesh_file.h"
#include "tests/support/scratch_folder.h"

namespace rob::runtime {
namespace {

using Eigen::Vector3d;
using motion::Capsule;

std::vector<Vector3d> box_points(double x, double y, double z) {
  std::vector<Vector3d> points;
  for (const double i : {-x, x})
    for (const double j : {-y, y})
      for (const double k : {-z, z}) points.emplace_back(i, j, k);
  return points;
}

double depth_in(const std::vector<Capsule>& capsules, const Vector3d& point) {
  double least = 1e9;
  for (const Capsule& capsule : capsules)
    least = std::min(least, motion::distance(capsule, Capsule{point, point, 0}));
  return least;
}

std::vector<Vector3d> turned_cloud(std::mt19937_64& random, int count) {
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond turn =
      Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
          .normalized();
  const Vector3d stretch(0.3 * std::abs(normal(random)), 0.05, 0.1);
  std::vector<Vector3d> points;
  for (int i = 0; i < count; ++i)
    points.push_back(
        turn * Vector3d(normal(random), normal(random), normal(random)).cwiseProduct(stretch) +
        Vector3d(0.1, -0.2, 0.3));
  return points;
}

}  // namespace

TEST_CASE("a cylinder gets the capsule of its radius, which stands out by it, a ball itself") {
  const std::vector<Body> rod{Rod{{0, 0, -0.1}, {0, 0, 0.3}, 0.05}};
  const auto around_rod = fitted_capsules(rod);
  REQUIRE(around_rod.size() == 1);
  CHECK(around_rod[0].radius == 0.05);
  CHECK(around_rod[0].to == Vector3d(0, 0, 0.3));
  CHECK(standing_out(around_rod, rod) == doctest::Approx(0.05));  // at the middle of its end

  const std::vector<Body> ball{Ball{{1, 2, 3}, 0.4}};
  const auto around_ball = fitted_capsules(ball);
  REQUIRE(around_ball.size() == 1);
  CHECK(around_ball[0].from == around_ball[0].to);
  CHECK(standing_out(around_ball, ball) < 1e-12);
}

// Of a long box with a square across of side 0.1: around its long axis the radius is the half
// diagonal, and all corners are on the edge of the balls at the ends.
TEST_CASE("a long box gets a capsule through its corners") {
  const std::vector<Body> box{convex_hull(box_points(0.5, 0.05, 0.05))};
  const auto capsules = fitted_capsules(box);
  REQUIRE(capsules.size() == 1);
  CHECK(capsules[0].radius == doctest::Approx(0.05 * std::sqrt(2.0)));
  CHECK((capsules[0].to - capsules[0].from).norm() == doctest::Approx(1.0));
  CHECK(standing_out(capsules, box) == doctest::Approx(0.05 * std::sqrt(2.0)).epsilon(1e-6));
}

TEST_CASE("a plate gets three capsules, and all of it is in them") {
  const std::vector<Body> plate{convex_hull(box_points(0.5, 0.3, 0.01))};
  const auto capsules = fitted_capsules(plate);
  CHECK(capsules.size() == 3);
  for (double x = -0.5; x <= 0.5; x += 0.02)
    for (double y = -0.3; y <= 0.3; y += 0.02) CHECK(depth_in(capsules, {x, y, 0.01}) < 1e-9);
}

TEST_CASE("whatever points there are, they and all between them are within the capsules") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> even;
  for (int run = 0; run < 20; ++run) {
    const std::vector<Vector3d> points = turned_cloud(random, 5 + 20 * run);
    const auto capsules = fitted_capsules({convex_hull(points)});
    REQUIRE(!capsules.empty());
    CHECK(capsules.size() <= 3);
    for (const Vector3d& a : points) {
      CHECK(depth_in(capsules, a) < 1e-9);
      const Vector3d& b = points[random() % points.size()];
      CHECK(depth_in(capsules, a + even(random) * (b - a)) < 1e-9);
    }
  }
}

TEST_CASE("flat, straight and single points have capsules, too") {
  for (const std::vector<Vector3d>& points :
       {std::vector<Vector3d>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
        {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {0.5, 0.5, 0.5}},
        {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}},
        {{1, 2, 3}},
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}) {
    const auto capsules = fitted_capsules({convex_hull(points)});
    CHECK(!capsules.empty());
    for (const Vector3d& point : points) CHECK(depth_in(capsules, point) < 1e-6);
  }
}

TEST_CASE("more than three bodies are one hull") {
  std::vector<Body> bodies;
  for (int i = 0; i < 5; ++i) bodies.emplace_back(Ball{{0.1 * i, 0, 0}, 0.02});
  bodies.emplace_back(Rod{{0, 0, 0}, {0, 0, 0.1}, 0.01});
  const auto capsules = fitted_capsules(bodies);
  CHECK(capsules.size() <= 3);
  CHECK(depth_in(capsules, {0.42, 0, 0}) < 1e-9);  // the outermost of the last ball
  CHECK(depth_in(capsules, {0.01, 0, 0.1}) < 1e-9);
}

TEST_CASE("the volume and the axes of a hull are those of a box") {
  const HullMoments moments = moments_of(convex_hull(box_points(0.5, 0.2, 0.1)));
  CHECK(moments.volume == doctest::Approx(8 * 0.5 * 0.2 * 0.1));
  CHECK(moments.centre.norm() < 1e-12);
  CHECK(std::abs(moments.axes.col(2).x()) == doctest::Approx(1));  // the longest comes last
}

TEST_CASE("meshes are found beside the URDF, above it, and under --package") {
  const test::ScratchFolder folder;
  namespace fs = std::filesystem;
  const auto put = [&](const std::string& name) {
    fs::create_directories((folder.path() / name).parent_path());
    std::ofstream(folder.path() / name) << "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 2 3\nf 1 2 4\n";
  };
  put("some_description/urdf/beside.obj");
  put("some_description/meshes/above.obj");
  put("elsewhere/other_pkg/m.obj");
  const std::string urdf = folder.file("some_description/urdf/arm.urdf");
  CHECK(find_mesh("beside.obj", urdf, "").ends_with("urdf/beside.obj"));
  CHECK(find_mesh("../meshes/above.obj", urdf, "").ends_with("above.obj"));
  CHECK(find_mesh("package://some_description/meshes/above.obj", urdf, "").ends_with("above.obj"));
  const std::string elsewhere = folder.file("elsewhere");
  CHECK(find_mesh("package://other_pkg/m.obj", urdf, elsewhere).ends_with("other_pkg/m.obj"));
  CHECK(find_mesh("package://other_pkg/m.obj", urdf, elsewhere + "/other_pkg").ends_with("m.obj"));
  CHECK(find_mesh("file://" + elsewhere + "/other_pkg/m.obj", urdf, "").ends_with("m.obj"));
  CHECK_THROWS_AS(find_mesh("package://other_pkg/m.obj", urdf, ""), motion::RobotFileError);
  CHECK_THROWS_AS(find_mesh("package://", urdf, ""), motion::RobotFileError);
  CHECK_THROWS_AS(find_mesh("http://a/b.stl", urdf, ""), motion::RobotFileError);
  CHECK(mesh_vertices(find_mesh("beside.obj", urdf, "")).size() >= 4);
}

TEST_CASE("a broken mesh is an error") {
  const test::ScratchFolder folder;
  for (const char* name : {"a.stl", "a.dae", "a.obj", "a.txt"}) {
    std::ofstream(folder.file(name)) << "solid nothing\n<COLLADA\n";
    CHECK_THROWS_AS(mesh_vertices(folder.file(name)), motion::RobotFileError);
  }
  std::ofstream(folder.file("cut.stl"), std::ios::binary)
      << std::string(80, ' ') << std::string("\xFF\xFF\xFF\x7F", 4) << "few";
  CHECK_THROWS_AS(mesh_vertices(folder.file("cut.stl")), motion::RobotFileError);
}

}  // namespace rob::runtime
