#include "runtime/meshes/mesh_obstacle.h"

#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/distance.h>
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "lang/text/visible.h"
#include "motion/robots/robot_file_error.h"
#include "runtime/meshes/mesh_file.h"

namespace rob::runtime {

namespace {

using Eigen::Vector3d;

constexpr double kLargestMesh = 100;     // m [choice] as the measures of other obstacles
constexpr double kFarAway = 0.05;        // m [choice] from there on the bounding sphere is enough
constexpr double kSolverError = 0.1e-3;  // m, which the solver may tell too much

/// All that is not above a face.
struct Face {
  Vector3d normal;  // outwards
  double height = 0;
};

double to_segment(const Vector3d& point, const motion::Capsule& segment) {
  const Vector3d along = segment.to - segment.from;
  const double length2 = along.squaredNorm();
  const double t =
      length2 > 0 ? std::clamp((point - segment.from).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (segment.from + t * along - point).norm();
}

Vector3d middle_of(const Hull& hull) {
  Vector3d low = hull.vertices.front();
  Vector3d high = low;
  for (const Vector3d& vertex : hull.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  return (low + high) / 2;
}

std::vector<Face> faces_of(const Hull& hull, const Vector3d& within) {
  std::vector<Face> faces;
  for (const auto& [a, b, c] : hull.faces) {
    const auto at = [&](int i) { return hull.vertices[static_cast<std::size_t>(i)]; };
    const Vector3d across = (at(b) - at(a)).cross(at(c) - at(a));
    if (!(across.norm() > 0)) continue;
    const Vector3d normal = across.normalized();
    const double height = normal.dot(at(a));
    const bool outwards = normal.dot(within) <= height;
    faces.push_back(outwards ? Face{normal, height} : Face{-normal, -height});
  }
  return faces;
}

/// Each edge once: two faces share it, and go round it in opposite directions.
std::vector<std::pair<Vector3d, Vector3d>> edges_of(const Hull& hull) {
  std::set<std::pair<int, int>> known;
  for (const auto& [a, b, c] : hull.faces)
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      known.insert(std::minmax(from, to));
  std::vector<std::pair<Vector3d, Vector3d>> edges;
  for (const auto& [from, to] : known)
    edges.emplace_back(hull.vertices[static_cast<std::size_t>(from)],
                       hull.vertices[static_cast<std::size_t>(to)]);
  return edges;
}

fcl::Convexd convex_of(const Hull& hull) {
  std::vector<int> faces;
  for (const auto& [a, b, c] : hull.faces) faces.insert(faces.end(), {3, a, b, c});
  return {std::make_shared<const std::vector<Vector3d>>(hull.vertices),
          static_cast<int>(hull.faces.size()), std::make_shared<const std::vector<int>>(faces)};
}

/// A hull whose distances FCL finds. Its own solver is taken: the other one that it has (libccd)
/// told up to 98 mm too much.
class MeshBody final : public motion::ConvexBody {
 public:
  explicit MeshBody(const Hull& hull)
      : middle_(middle_of(hull)),
        faces_(faces_of(hull, middle_)),
        edges_(edges_of(hull)),
        convex_(convex_of(hull)) {
    for (const Vector3d& vertex : hull.vertices)
      radius_ = std::max(radius_, (vertex - middle_).norm());
  }

  double distance(const motion::Capsule& capsule) const noexcept override {
    const double outside = to_segment(middle_, capsule) - radius_ - capsule.radius;
    if (outside > kFarAway) return outside;
    try {
      const double found = solved(capsule);
      if (found > 0) return found - kSolverError;
    } catch (...) {
      // Whatever the solver could not do: it counts as contact.
    }
    return std::min(depth(capsule), 0.0);
  }

  std::vector<std::pair<Vector3d, Vector3d>> edges() const override { return edges_; }

 private:
  /// Below 0 where they touch.
  double solved(const motion::Capsule& capsule) const {
    const Vector3d along = capsule.to - capsule.from;
    const fcl::Capsuled body(capsule.radius, along.norm());
    fcl::Transform3d place = fcl::Transform3d::Identity();
    place.translation() = (capsule.from + capsule.to) / 2;
    place.linear() =
        Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), along).toRotationMatrix();
    fcl::DistanceRequestd request;
    request.gjk_solver_type = fcl::GJKSolverType::GST_INDEP;
    fcl::DistanceResultd result;
    fcl::distance(&body, place, &convex_, fcl::Transform3d::Identity(), request, result);
    return result.min_distance;
  }

  /// The least way along a face's normal after which the two are apart, as a distance below 0.
  double depth(const motion::Capsule& capsule) const {
    double most = -std::numeric_limits<double>::infinity();
    for (const Face& face : faces_) {
      const double nearest = std::min(face.normal.dot(capsule.from), face.normal.dot(capsule.to));
      most = std::max(most, nearest - face.height);
    }
    return faces_.empty() ? 0 : most - capsule.radius;
  }

  Vector3d middle_;
  double radius_ = 0;  // m, of the sphere around middle_ that holds it
  std::vector<Face> faces_;
  std::vector<std::pair<Vector3d, Vector3d>> edges_;
  fcl::Convexd convex_;
};

}  // namespace

std::shared_ptr<const motion::ConvexBody> convex_body(const Hull& hull) {
  return std::make_shared<const MeshBody>(hull);
}

std::shared_ptr<const motion::ConvexBody> body_of_mesh(const std::string& file,
                                                       const motion::Pose& place) {
  std::vector<Vector3d> vertices = mesh_vertices(file);
  for (Vector3d& vertex : vertices) {
    if (!(vertex.norm() <= kLargestMesh))
      throw motion::RobotFileError(fmt::format(
          "{}: the mesh reaches farther than {} m from its origin; are its lengths in m?",
          lang::visible(file), kLargestMesh));
    vertex = motion::place_of(vertex, place);
  }
  return convex_body(convex_hull(vertices));
}

void read_meshes(motion::CollisionData& data) {
  for (const motion::MeshObstacle& mesh : data.meshes) {
    try {
      data.obstacles.push_back({.name = mesh.name, .shape = body_of_mesh(mesh.file, mesh.place)});
    } catch (const motion::RobotFileError& error) {
      throw motion::RobotFileError(mesh.where + error.what());
    }
  }
  data.meshes.clear();
}

}  // namespace rob::runtime
