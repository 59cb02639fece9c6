#include "motion/collision/distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rob::motion {

namespace {

using Eigen::Vector3d;

/// From a point to a segment.
double to_segment(const Vector3d& point, const Capsule& segment) noexcept {
  const Vector3d along = segment.to - segment.from;
  const double length2 = along.squaredNorm();
  const double t =
      length2 > 0 ? std::clamp((point - segment.from).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (segment.from + t * along - point).norm();
}

/// Between two segments: it is at an end of one of them, or where both lines are nearest.
double between_segments(const Capsule& a, const Capsule& b) noexcept {
  const double at_ends = std::min(
      {to_segment(a.from, b), to_segment(a.to, b), to_segment(b.from, a), to_segment(b.to, a)});
  const Vector3d along_a = a.to - a.from;
  const Vector3d along_b = b.to - b.from;
  const Vector3d apart = b.from - a.from;
  const double aa = along_a.squaredNorm();
  const double ab = along_a.dot(along_b);
  const double bb = along_b.squaredNorm();
  const double determinant = aa * bb - ab * ab;
  constexpr double kParallel = 1e-14;  // [choice] then an end is as near, but for rounding
  if (!(determinant > kParallel * aa * bb)) return at_ends;
  const double s = (apart.dot(along_a) * bb - apart.dot(along_b) * ab) / determinant;
  const double t = (apart.dot(along_a) * ab - apart.dot(along_b) * aa) / determinant;
  if (s < 0 || s > 1 || t < 0 || t > 1) return at_ends;
  return std::min(at_ends, (apart + t * along_b - s * along_a).norm());
}

/// The part of each coordinate that lies outside of the box, with its sign.
Vector3d excess(const Vector3d& point, const Vector3d& half) noexcept {
  return point - point.cwiseMax(-half).cwiseMin(half);
}

/// From a segment, seen from the box's centre. The squared distance at the share t of the segment
/// is convex. Its derivative is a polyline in t, which bends where the segment passes one of the
/// six planes of the box; the least distance lies where this polyline crosses 0.
double segment_to_box(const Vector3d& from, const Vector3d& to, const Vector3d& half) noexcept {
  const Vector3d along = to - from;
  const auto excess_at = [&](double t) { return excess(from + t * along, half); };
  const auto slope_at = [&](double t) { return excess_at(t).dot(along); };
  double falls = 0;  // the greatest t that is known to be before the least distance
  double rises = 1;  // the smallest that is known to be after it
  double falling = slope_at(falls);
  double rising = slope_at(rises);
  if (falling >= 0) return excess_at(falls).norm();
  if (rising <= 0) return excess_at(rises).norm();
  for (int i = 0; i < 6; ++i) {
    const double plane = i < 3 ? half[i] : -half[i - 3];
    const double t = (plane - from[i % 3]) / along[i % 3];  // not in between where parallel
    if (!(t > falls && t < rises)) continue;
    const double slope = slope_at(t);
    (slope < 0 ? falls : rises) = t;
    (slope < 0 ? falling : rising) = slope;
  }
  const double least = falls + (rises - falls) * falling / (falling - rising);
  return excess_at(least).norm();
}

/// How far a segment that meets the box must be moved at least so as not to. The middles for which
/// they meet fill a body of the box' edges and the segment as a further edge: each of its faces
/// lies along two of these four.
double depth_in_box(const Vector3d& from, const Vector3d& to, const Vector3d& half) noexcept {
  const Vector3d middle = (from + to) / 2;
  const Vector3d along = (to - from) / 2;
  const auto out_along = [&](const Vector3d& way) {
    return way.cwiseAbs().dot(half) + std::abs(way.dot(along)) - std::abs(way.dot(middle));
  };
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i) {
    const Vector3d edge = Vector3d::Unit(i);
    least = std::min(least, out_along(edge));
    const Vector3d across = edge.cross(along);
    constexpr double kParallel = 1e-9;  // [choice] then the edges are ways as good
    if (across.norm() > kParallel * along.norm())
      least = std::min(least, out_along(across.normalized()));
  }
  return std::max(least, 0.0);
}

}  // namespace

double distance(const Capsule& capsule, const Sphere& sphere) noexcept {
  return to_segment(sphere.centre, capsule) - sphere.radius - capsule.radius;
}

double distance(const Capsule& a, const Capsule& b) noexcept {
  return between_segments(a, b) - a.radius - b.radius;
}

double distance(const Capsule& capsule, const Box& box) noexcept {
  const Capsule seen = moved(capsule, inverse(box.centre));
  const double apart = segment_to_box(seen.from, seen.to, box.half);
  if (apart > 0) return apart - capsule.radius;
  return -depth_in_box(seen.from, seen.to, box.half) - capsule.radius;
}

double distance(const Capsule& capsule, const HalfSpace& below) noexcept {
  return std::min(capsule.from.z(), capsule.to.z()) - below.height - capsule.radius;
}

double distance(const Capsule& capsule, const std::shared_ptr<const ConvexBody>& body) noexcept {
  return body->distance(capsule);
}

double distance(const Capsule& capsule, const Obstacle& obstacle) noexcept {
  return std::visit([&](const auto& shape) { return distance(capsule, shape); }, obstacle.shape);
}

}  // namespace rob::motion
