#include "tests/support/ordered_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rob::test {

namespace {

using Eigen::Vector3d;

/// A stretch of a piece of the path, as shares of its way; none: begin > end.
struct Stretch {
  double begin = 1;
  double end = 0;
  bool none() const { return begin > end; }
};

/// The part of the piece from a to b that is at most `distance` from p.
Stretch near(const Vector3d& p, const Vector3d& a, const Vector3d& b, double distance) {
  const Vector3d way = b - a;
  const double square = way.squaredNorm();
  if (square == 0) return (p - a).norm() <= distance ? Stretch{0, 1} : Stretch{};
  const double middle = (p - a).dot(way) / square;
  const double beside = (p - a - middle * way).squaredNorm();
  const double half = distance * distance - beside;
  if (half < 0) return {};
  const double reach = std::sqrt(half / square);
  return {std::max(middle - reach, 0.0), std::min(middle + reach, 1.0)};
}

/// Whether both can be gone along with no greater distance. Of each piece of the path that part is
/// kept at which one can be while the curve is at its present place.
bool within(const std::vector<Vector3d>& curve, const std::vector<Vector3d>& path,
            double distance) {
  if ((curve.front() - path.front()).norm() > distance) return false;
  std::vector<Stretch> reached(path.size() - 1);
  std::size_t first = 0, end = 1;  // all others are none
  reached[0] = {0, 0};
  for (const Vector3d& p : curve) {
    bool enters = false;  // over the corner before this piece
    std::size_t last = first;
    for (std::size_t i = first; i < reached.size() && (i < end || enters); ++i) {
      const Stretch free = near(p, path[i], path[i + 1], distance);
      Stretch& at = reached[i];
      if (enters && free.begin <= 0) {
        at = free;
      } else {
        at = at.none() ? Stretch{} : Stretch{std::max(at.begin, free.begin), free.end};
      }
      enters = !at.none() && at.end >= 1;
      if (!at.none()) last = i + 1;
    }
    while (first < last && reached[first].none()) ++first;
    if (first == last) return false;
    end = last;
  }
  return end == reached.size() && reached.back().end >= 1;
}

}  // namespace

double ordered_distance(const std::vector<Vector3d>& curve, const std::vector<Vector3d>& path,
                        double most) {
  if (!within(curve, path, most)) return std::numeric_limits<double>::infinity();
  double low = 0, high = most;
  while (high - low > std::max(0.005 * high, 1e-6)) {
    const double middle = (low + high) / 2;
    (within(curve, path, middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace rob::test
