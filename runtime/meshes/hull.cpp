#include "runtime/meshes/hull.h"

#include <libqhull_r/libqhull_r.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace rob::runtime {

namespace {

using Eigen::Vector3d;

/// One computation of Qhull, which keeps all it knows in one object, and its complaints to itself.
class Computation {
 public:
  Computation() : silence_(std::fopen("/dev/null", "w")) { qh_zero(&qhull_, silence_); }
  ~Computation() {
    int rest = 0;
    int blocks = 0;
    qh_freeqhull(&qhull_, !qh_ALL);
    qh_memfreeshort(&qhull_, &rest, &blocks);
    if (silence_ != nullptr) std::fclose(silence_);
  }
  Computation(const Computation&) = delete;
  Computation& operator=(const Computation&) = delete;

  /// Nothing where the points have no hull with a volume.
  std::optional<Hull> hull_of(std::vector<Vector3d> points, const char* options) {
    static_assert(sizeof(Vector3d) == 3 * sizeof(double));
    std::string command = std::string("qhull ") + options;
    const int failed =
        qh_new_qhull(&qhull_, 3, static_cast<int>(points.size()), points.front().data(), False,
                     command.data(), nullptr, silence_);
    if (failed != 0) return std::nullopt;
    Hull hull;
    std::map<int, int> numbers;
    for (facetT* facet = qhull_.facet_list; facet != nullptr && facet->next != nullptr;
         facet = facet->next)
      add(*facet, points, numbers, hull);
    return hull;
  }

 private:
  void add(const facetT& facet, const std::vector<Vector3d>& points, std::map<int, int>& numbers,
           Hull& hull) {
    std::array<int, 3> face{};
    for (int corner = 0; corner < 3; ++corner) {
      const auto* const vertex = static_cast<const vertexT*>(facet.vertices->e[corner].p);
      const int id = qh_pointid(&qhull_, vertex->point);
      const auto [found, fresh] = numbers.emplace(id, static_cast<int>(hull.vertices.size()));
      if (fresh) hull.vertices.push_back(points.at(static_cast<std::size_t>(id)));
      face[static_cast<std::size_t>(corner)] = found->second;
    }
    hull.faces.push_back(face);
  }

  std::FILE* silence_;
  qhT qhull_{};
};

/// Points on a line, or in one place: its two ends.
Hull line_hull(const std::vector<Vector3d>& points) {
  const auto farthest_from = [&](const Vector3d& from) {
    return *std::ranges::max_element(
        points, {}, [&](const Vector3d& point) { return (point - from).squaredNorm(); });
  };
  const Vector3d end = farthest_from(points.front());
  return {{end, farthest_from(end)}, {{0, 1, 1}}};
}

double distance_to_segment(const Vector3d& a, const Vector3d& b, const Vector3d& point) {
  const Vector3d way = b - a;
  const double square = way.squaredNorm();
  const double share = square > 0 ? std::clamp((point - a).dot(way) / square, 0.0, 1.0) : 0.0;
  return (a + share * way - point).norm();
}

double distance_to_triangle(const std::array<Vector3d, 3>& t, const Vector3d& point) {
  const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double area = normal.norm();
  bool above = area > 0;
  for (std::size_t i = 0; i < 3 && above; ++i) {
    const Vector3d edge = t[(i + 1) % 3] - t[i];
    above = edge.cross(point - t[i]).dot(normal) >= 0;
  }
  if (above) return std::abs(normal.dot(point - t[0])) / area;
  return std::min({distance_to_segment(t[0], t[1], point), distance_to_segment(t[1], t[2], point),
                   distance_to_segment(t[2], t[0], point)});
}

std::array<Vector3d, 3> corners(const Hull& hull, const std::array<int, 3>& face) {
  const auto at = [&](int i) { return hull.vertices[static_cast<std::size_t>(i)]; };
  return {at(face[0]), at(face[1]), at(face[2])};
}

Vector3d middle(const std::vector<Vector3d>& points) {
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& point : points) sum += point;
  return sum / static_cast<double>(points.size());
}

bool is_inside(const Hull& hull, const Vector3d& centre, const Vector3d& point) {
  return std::ranges::all_of(hull.faces, [&](const std::array<int, 3>& face) {
    const std::array<Vector3d, 3> t = corners(hull, face);
    const Vector3d normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double within = normal.dot(centre - t[0]);
    return normal.dot(point - t[0]) * within > 0;
  });
}

}  // namespace

Hull convex_hull(const std::vector<Vector3d>& points) {
  // Points in one plane have a hull once they are moved by the least that can be computed with
  // (QJ).
  for (const char* options : {"Qt", "QJ"}) {
    if (points.size() <= 3) break;
    if (auto hull = Computation().hull_of(points, options)) return std::move(*hull);
  }
  if (points.size() == 3) return {points, {{0, 1, 2}}};
  return line_hull(points);
}

HullMoments moments_of(const Hull& hull) {
  const Vector3d within = middle(hull.vertices);
  double volume = 0;
  Vector3d first = Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (const std::array<int, 3>& face : hull.faces) {  // a pyramid each, `within` its top
    std::array<Vector3d, 3> t = corners(hull, face);
    for (Vector3d& corner : t) corner -= within;
    const double part = std::abs(t[0].dot(t[1].cross(t[2]))) / 6;
    const Vector3d sum = t[0] + t[1] + t[2];
    volume += part;
    first += part / 4 * sum;
    second += part / 20 * sum * sum.transpose();
    for (const Vector3d& corner : t) second += part / 20 * corner * corner.transpose();
  }
  HullMoments moments;
  moments.volume = volume;
  if (!(volume > 0)) {  // without volume its vertices count
    moments.centre = within;
    for (const Vector3d& v : hull.vertices) second += (v - within) * (v - within).transpose();
  } else {
    moments.centre = within + first / volume;
    second -= first * first.transpose() / volume;
  }
  moments.axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(second).eigenvectors();
  return moments;
}

std::vector<Vector3d> slice_of(const Hull& hull, const Vector3d& direction, double low,
                               double high) {
  std::vector<Vector3d> points;
  for (const Vector3d& vertex : hull.vertices) {
    const double at = direction.dot(vertex);
    if (at >= low && at <= high) points.push_back(vertex);
  }
  for (const std::array<int, 3>& face : hull.faces) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d& a = hull.vertices[static_cast<std::size_t>(face[i])];
      const Vector3d& b = hull.vertices[static_cast<std::size_t>(face[(i + 1) % 3])];
      for (const double plane : {low, high}) {
        const double from_a = plane - direction.dot(a);
        const double way = direction.dot(b - a);
        if (from_a * (from_a - way) < 0) points.push_back(a + from_a / way * (b - a));
      }
    }
  }
  return points;
}

double distance_to(const Hull& hull, const Vector3d& point) {
  const Vector3d centre = middle(hull.vertices);
  if (hull.faces.size() > 3 && is_inside(hull, centre, point)) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const std::array<int, 3>& face : hull.faces)
    least = std::min(least, distance_to_triangle(corners(hull, face), point));
  return least;
}

}  // namespace rob::runtime
