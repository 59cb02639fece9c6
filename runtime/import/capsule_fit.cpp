#include "runtime/import/capsule_fit.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace rob::runtime {

namespace {

using Eigen::Vector3d;
using motion::Capsule;

constexpr std::size_t kMostParts = motion::kMostCapsules;
constexpr double kMostOfHull = 2;              // times its volume; above, it is cut
constexpr int kEdges = 16;                     // of a prism around a rod
constexpr int kDirections = 200;               // in which a capsule is looked at
constexpr double kThinnest = 1e-5;             // m, of a radius in a robot file
constexpr std::size_t kMany = 1000;            // [choice] vertices
constexpr double kGolden = 2.399963229728653;  // rad, from direction to direction on a sphere

double volume_of(const Capsule& capsule) {
  const double r = capsule.radius;
  return std::numbers::pi * r * r * ((capsule.to - capsule.from).norm() + 4.0 / 3.0 * r);
}

/// The capsule around the line through `centre` along `direction`: the ends are as near to each
/// other as all vertices permit.
Capsule around(const std::vector<Vector3d>& vertices, const Vector3d& centre,
               const Vector3d& direction) {
  double radius = kThinnest;
  for (const Vector3d& vertex : vertices)
    radius = std::max(radius, direction.cross(vertex - centre).norm());
  double from = std::numeric_limits<double>::infinity();
  double to = -from;
  for (const Vector3d& vertex : vertices) {
    const double along = direction.dot(vertex - centre);
    const double beside = direction.cross(vertex - centre).norm();
    const double reach = std::sqrt(std::max(0.0, radius * radius - beside * beside));
    from = std::min(from, along + reach);
    to = std::max(to, along - reach);
  }
  if (from > to) from = to = (from + to) / 2;  // a ball covers them
  return {centre + from * direction, centre + to * direction, radius};
}

/// Two directions across the first, and across each other.
std::pair<Vector3d, Vector3d> across(const Vector3d& direction) {
  const Vector3d one = direction.unitOrthogonal();
  return {one, direction.cross(one)};
}

/// Evenly spread over the sphere, the poles of `up` and its equator among them.
std::vector<Vector3d> directions_about(const Vector3d& up) {
  const auto [u, v] = across(up);
  std::vector<Vector3d> directions{up, -up};
  for (int i = 0; i < kDirections; ++i) {
    const double height = 1 - (2.0 * i + 1) / kDirections;
    const double angle = kGolden * i;
    const double flat = std::sqrt(1 - height * height);
    directions.push_back(height * up + flat * (std::cos(angle) * u + std::sin(angle) * v));
    directions.push_back(std::cos(angle) * u + std::sin(angle) * v);
  }
  return directions;
}

/// The vertices that are outermost in evenly spread directions, where there are many.
std::vector<Vector3d> outermost(const std::vector<Vector3d>& vertices) {
  if (vertices.size() <= kMany) return vertices;
  std::set<std::size_t> kept;
  for (const Vector3d& direction : directions_about(Vector3d::UnitZ())) {
    const auto most = std::ranges::max_element(
        vertices, {}, [&](const Vector3d& vertex) { return direction.dot(vertex); });
    kept.insert(static_cast<std::size_t>(most - vertices.begin()));
  }
  std::vector<Vector3d> outer;
  for (const std::size_t i : kept) outer.push_back(vertices[i]);
  return outer;
}

/// The line through the two vertices that are farthest from each other.
std::pair<Vector3d, Vector3d> longest(const std::vector<Vector3d>& all) {
  const std::vector<Vector3d> vertices = outermost(all);
  std::pair<Vector3d, Vector3d> ends(vertices.front(), vertices.front());
  double most = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double square = (vertices[i] - vertices[j]).squaredNorm();
      if (square <= most) continue;
      most = square;
      ends = {vertices[i], vertices[j]};
    }
  return ends;
}

Capsule smallest_around(const Hull& hull) {
  const HullMoments moments = moments_of(hull);
  Capsule best = around(hull.vertices, moments.centre, moments.axes.col(0));
  const auto offer = [&](const Capsule& capsule) {
    if (volume_of(capsule) < volume_of(best)) best = capsule;
  };
  for (int i = 1; i < 3; ++i) offer(around(hull.vertices, moments.centre, moments.axes.col(i)));
  const auto [a, b] = longest(hull.vertices);
  if (a != b) offer(around(hull.vertices, a, (b - a).normalized()));
  return best;
}

/// The principal axis along which the hull is longest, and from where to where it goes.
struct Extent {
  Vector3d direction;
  double low = 0;
  double high = 0;
};

Extent longest_extent(const Hull& hull) {
  const HullMoments moments = moments_of(hull);
  Extent longest;
  for (int i = 0; i < 3; ++i) {
    Extent extent{moments.axes.col(i), std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
    for (const Vector3d& vertex : hull.vertices) {
      extent.low = std::min(extent.low, extent.direction.dot(vertex));
      extent.high = std::max(extent.high, extent.direction.dot(vertex));
    }
    if (i == 0 || extent.high - extent.low > longest.high - longest.low) longest = extent;
  }
  return longest;
}

std::vector<Capsule> around_parts(const Hull& hull, std::size_t parts) {
  const Extent extent = longest_extent(hull);
  const double step = (extent.high - extent.low) / static_cast<double>(parts);
  std::vector<Capsule> capsules;
  for (std::size_t i = 0; i < parts; ++i) {
    const double low = extent.low + step * static_cast<double>(i);
    // The outer ends are beyond the outer vertices, whatever is lost by rounding.
    const std::vector<Vector3d> slice = slice_of(hull, extent.direction, i == 0 ? low - step : low,
                                                 i + 1 == parts ? extent.high + step : low + step);
    if (!slice.empty()) capsules.push_back(smallest_around(convex_hull(slice)));
  }
  return capsules;
}

double volume_of(const std::vector<Capsule>& capsules) {
  double sum = 0;
  for (const Capsule& capsule : capsules) sum += volume_of(capsule);
  return sum;
}

std::vector<Capsule> around_hull(const Hull& hull, std::size_t most) {
  const double allowed = kMostOfHull * moments_of(hull).volume;
  std::vector<Capsule> best{smallest_around(hull)};
  for (std::size_t parts = 2; parts <= most && volume_of(best) > allowed; ++parts) {
    std::vector<Capsule> cut = around_parts(hull, parts);
    if (volume_of(cut) < volume_of(best)) best = std::move(cut);
  }
  return best;
}

/// Points whose hull the body lies in.
void add_outline(const Body& body, std::vector<Vector3d>& points) {
  if (const Hull* hull = std::get_if<Hull>(&body)) {
    points.insert(points.end(), hull->vertices.begin(), hull->vertices.end());
  } else if (const Ball* ball = std::get_if<Ball>(&body)) {
    for (int corner = 0; corner < 8; ++corner)  // those of a cube
      points.push_back(ball->centre + ball->radius * Vector3d((corner & 1) != 0 ? 1 : -1,
                                                              (corner & 2) != 0 ? 1 : -1,
                                                              (corner & 4) != 0 ? 1 : -1));
  } else {
    const Rod& rod = std::get<Rod>(body);
    const auto [u, v] = across((rod.to - rod.from).normalized());
    const double radius = rod.radius / std::cos(std::numbers::pi / kEdges);
    for (int i = 0; i < kEdges; ++i) {
      const double angle = 2 * std::numbers::pi * i / kEdges;
      const Vector3d edge = radius * (std::cos(angle) * u + std::sin(angle) * v);
      points.push_back(rod.from + edge);
      points.push_back(rod.to + edge);
    }
  }
}

double distance_to(const Body& body, const Vector3d& point) {
  if (const Ball* ball = std::get_if<Ball>(&body))
    return std::max(0.0, (point - ball->centre).norm() - ball->radius);
  if (const Hull* hull = std::get_if<Hull>(&body)) return distance_to(*hull, point);
  const Rod& rod = std::get<Rod>(body);
  const Vector3d along = (rod.to - rod.from).normalized();
  const double at = along.dot(point - rod.from);
  const double beyond = std::max({0.0, -at, at - (rod.to - rod.from).norm()});
  const double beside = std::max(0.0, along.cross(point - rod.from).norm() - rod.radius);
  return std::hypot(beyond, beside);
}

}  // namespace

std::vector<Capsule> fitted_capsules(const std::vector<Body>& bodies) {
  if (bodies.size() > kMostParts) {
    std::vector<Vector3d> points;
    for (const Body& body : bodies) add_outline(body, points);
    return around_hull(convex_hull(points), kMostParts);
  }
  std::vector<Capsule> capsules;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const std::size_t most = kMostParts - capsules.size() - (bodies.size() - i - 1);
    if (const Ball* ball = std::get_if<Ball>(&bodies[i])) {
      capsules.push_back({ball->centre, ball->centre, std::max(ball->radius, kThinnest)});
    } else if (const Rod* rod = std::get_if<Rod>(&bodies[i])) {
      capsules.push_back({rod->from, rod->to, std::max(rod->radius, kThinnest)});
    } else {
      const auto parts = around_hull(std::get<Hull>(bodies[i]), most);
      capsules.insert(capsules.end(), parts.begin(), parts.end());
    }
  }
  return capsules;
}

/// A hull of very many vertices is looked at by its outermost: what stands out from those does so a
/// little more.
double standing_out(const std::vector<Capsule>& capsules, const std::vector<Body>& all) {
  std::vector<Body> bodies = all;
  for (Body& body : bodies)
    if (Hull* const hull = std::get_if<Hull>(&body);
        hull != nullptr && hull->vertices.size() > kMany)
      *hull = convex_hull(outermost(hull->vertices));
  double most = 0;
  // The distance to a convex body is greatest at the outermost: on the balls at the ends.
  for (const Capsule& capsule : capsules) {
    const Vector3d way = capsule.to - capsule.from;
    const Vector3d up = way.norm() > 0 ? Vector3d(way.normalized()) : Vector3d::UnitZ();
    for (const Vector3d& direction : directions_about(up)) {
      for (const Vector3d& end : {capsule.from, capsule.to}) {
        const Vector3d point = end + capsule.radius * direction;
        double least = std::numeric_limits<double>::infinity();
        for (const Body& body : bodies) least = std::min(least, distance_to(body, point));
        most = std::max(most, least);
      }
    }
  }
  return most;
}

}  // namespace rob::runtime
