#include "runtime/import/link_bodies.h"

#include <fmt/format.h>

#include "lang/text/visible.h"
#include "motion/robots/robot_file_error.h"
#include "runtime/meshes/mesh_file.h"

namespace rob::runtime {

namespace {

using Eigen::Vector3d;

constexpr double kLargest = 20;  // [choice] m, from the frame of its link

[[noreturn]] void refuse_shape(const std::string& urdf, const RigidBody& link,
                               const std::string& problem) {
  throw motion::RobotFileError(
      lang::visible(fmt::format("{}: a <collision> at link {}: {}", urdf, link.link, problem)));
}

std::vector<Vector3d> corners_of(const Vector3d& size) {
  std::vector<Vector3d> corners;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double z : {-0.5, 0.5}) corners.push_back(size.cwiseProduct(Vector3d(x, y, z)));
  return corners;
}

Hull placed_hull(std::vector<Vector3d> points, const motion::Pose& place) {
  for (Vector3d& point : points) point = motion::place_of(point, place);
  return convex_hull(points);
}

}  // namespace

std::vector<Body> bodies_of(const RigidBody& link, const std::string& urdf,
                            const std::string& packages) {
  const auto check = [&](bool sound, const char* problem) {
    if (!sound) refuse_shape(urdf, link, problem);
  };
  const auto positive = [](double length) { return length > 0 && length <= kLargest; };
  std::vector<Body> bodies;
  for (const UrdfShape& shape : link.shapes) {
    const motion::Pose& place = shape.place;
    check(place.position.norm() <= kLargest, "its origin is far away; are the lengths in m?");
    switch (shape.kind) {
      case UrdfShape::Kind::Sphere:
        check(positive(shape.radius), "radius must be above 0, at most 20 m");
        bodies.push_back(Ball{place.position, shape.radius});
        break;
      case UrdfShape::Kind::Cylinder: {
        check(positive(shape.radius), "radius must be above 0, at most 20 m");
        check(positive(shape.length), "length must be above 0, at most 20 m");
        const Vector3d half(0, 0, shape.length / 2);
        bodies.push_back(
            Rod{motion::place_of(-half, place), motion::place_of(half, place), shape.radius});
        break;
      }
      case UrdfShape::Kind::Box:
        check(shape.size.minCoeff() > 0 && shape.size.maxCoeff() <= kLargest,
              "the sizes of a box must be above 0, at most 20 m");
        bodies.push_back(placed_hull(corners_of(shape.size), place));
        break;
      case UrdfShape::Kind::Mesh: {
        std::vector<Vector3d> points = mesh_vertices(find_mesh(shape.mesh, urdf, packages));
        for (Vector3d& point : points) {
          point = point.cwiseProduct(shape.scale);
          check(point.norm() <= kLargest,
                "the mesh is more than 20 m long; is it in mm? scale=\"0.001 0.001 0.001\"");
        }
        bodies.push_back(placed_hull(std::move(points), place));
        break;
      }
    }
  }
  return bodies;
}

}  // namespace rob::runtime
