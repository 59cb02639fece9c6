#include "tests/support/path_deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace rob::test {

namespace {

using Eigen::Vector3d;

/// The share of the way from a to b where it is nearest to p.
double nearest_share(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d way = b - a;
  const double square = way.squaredNorm();
  return square > 0 ? std::clamp((p - a).dot(way) / square, 0.0, 1.0) : 0.0;
}

double distance_to(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  return (p - a - nearest_share(p, a, b) * (b - a)).norm();
}

/// mm along the path.
struct Range {
  double from = 0;
  double to = 0;
};

/// The place on the path where the tool is, going along with it.
class Follower {
 public:
  static constexpr std::size_t kNear = 4;  ///< pieces that a place goes on by, mostly

  Follower(const std::vector<Vector3d>& places, double window)
      : places_(places), window_(window), length_(places.size(), 0.0) {
    for (std::size_t i = 1; i < places.size(); ++i)
      length_[i] = length_[i - 1] + (places[i] - places[i - 1]).norm();
  }

  /// The distance of p from the path near where it was last; goes on to the nearest place.
  double follow(const Vector3d& p) {
    double least = std::numeric_limits<double>::infinity();
    const auto [from, to] = range();
    for (std::size_t i = piece_at(from); i + 1 < places_.size() && length_[i] <= to; ++i) {
      const double share = nearest_share(p, places_[i], places_[i + 1]);
      const double distance = (p - places_[i] - share * (places_[i + 1] - places_[i])).norm();
      if (distance >= least) continue;
      least = distance;
      here_ = length_[i] + share * (length_[i + 1] - length_[i]);
    }
    return least;
  }

  /// The least of what allowed(length along the path) leaves of the distances there: a tool that is
  /// within what is allowed of one part of the path may be nearer to another one. Where that is no
  /// more than `enough` it is not looked for any further.
  template <typename Allowed>
  double excess(const Vector3d& p, const Range& range, double enough, Allowed&& allowed) {
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](std::size_t i) {
      const double share = nearest_share(p, places_[i], places_[i + 1]);
      const double distance = (p - places_[i] - share * (places_[i + 1] - places_[i])).norm();
      const double here = distance - allowed((length_[i] + length_[i + 1]) / 2);
      if (here < least) least = here, near_ = i;
      return least <= enough;
    };
    const std::size_t first = piece_at(range.from);
    const auto counts = [&](std::size_t i) {
      return i + 1 < places_.size() && length_[i] <= range.to;
    };
    for (std::size_t i = near_; i < near_ + kNear; ++i)
      if (i >= first && counts(i) && look(i)) return least;
    for (std::size_t i = first; counts(i); ++i)
      if (look(i)) return least;
    return least;
  }

  Range range() const { return {here_ - window_, here_ + window_}; }
  double length_at(std::size_t place) const { return length_[place]; }

 private:
  std::size_t piece_at(double length) const {
    const auto next = std::upper_bound(length_.begin(), length_.end(), length);
    return next == length_.begin() ? 0 : static_cast<std::size_t>(next - length_.begin()) - 1;
  }

  const std::vector<Vector3d>& places_;
  double window_;
  std::vector<double> length_;
  double here_ = 0;
  std::size_t near_ = 0;  ///< the piece of the last place
};

/// The least distance that the curve comes to each programmed point while it is near it.
class Misses {
 public:
  Misses(const ProgrammedPath& path, const Follower& follower)
      : path_(path), follower_(follower), points_(path.points) {
    if (points_.empty()) {
      points_.resize(path.places.size());
      std::iota(points_.begin(), points_.end(), std::size_t{0});
    }
    least_.assign(points_.size(), std::numeric_limits<double>::infinity());
  }

  void pass(const Vector3d& from, const Vector3d& to, const Range& range) {
    const auto before = [&](std::size_t point, double length) {
      return follower_.length_at(point) < length;
    };
    const auto begin = std::lower_bound(points_.begin(), points_.end(), range.from, before);
    for (auto i = static_cast<std::size_t>(begin - points_.begin());
         i < points_.size() && follower_.length_at(points_[i]) <= range.to; ++i)
      least_[i] = std::min(least_[i], distance_to(path_.places[points_[i]], from, to));
  }

  const std::vector<double>& least() const { return least_; }

  Range range(const PathStretch& stretch, double window) const {
    return {follower_.length_at(points_[stretch.from]) - window,
            follower_.length_at(points_[stretch.to]) + window};
  }

  /// What the points before and behind a place so far along the path allow, and the way between.
  double allowed(const PathBounds& bounds, double length) const {
    const auto before = [&](double at, std::size_t point) {
      return at < follower_.length_at(point);
    };
    const auto next = static_cast<std::size_t>(
        std::upper_bound(points_.begin(), points_.end(), length, before) - points_.begin());
    if (next == bounds.misses.size()) return bounds.misses.back();
    const double beside = bounds.besides.empty() ? 0 : bounds.besides[next];
    const double behind = std::max(beside, bounds.misses[next]);
    return next > 0 ? std::max(bounds.misses[next - 1], behind) : behind;
  }

 private:
  const ProgrammedPath& path_;
  const Follower& follower_;
  std::vector<std::size_t> points_;
  std::vector<double> least_;
};

/// Cubic Hermite pieces through places with velocities at times.
class HermiteCurve {
 public:
  explicit HermiteCurve(int parts) : parts_(parts) {}

  void add(double t, const Vector3d& place, const Vector3d& velocity) {
    if (!curve_.empty()) {
      const double T = t - t_;
      for (int k = 1; k <= parts_; ++k) {
        const double s = static_cast<double>(k) / parts_, r = 1 - s;
        curve_.push_back(r * r * (1 + 2 * s) * place_ + s * r * r * T * velocity_ +
                         s * s * (3 - 2 * s) * place - s * s * r * T * velocity);
      }
    } else {
      curve_.push_back(place);
    }
    t_ = t, place_ = place, velocity_ = velocity;
  }
  std::vector<Vector3d> take() { return std::move(curve_); }

 private:
  int parts_;
  double t_ = 0;
  Vector3d place_ = Vector3d::Zero(), velocity_ = Vector3d::Zero();
  std::vector<Vector3d> curve_;
};

Vector3d first_of(const AxisValues& values, std::size_t count) {
  Vector3d place = Vector3d::Zero();
  for (std::size_t i = 0; i < std::min<std::size_t>(count, 3); ++i)
    place[static_cast<Eigen::Index>(i)] = values[i];
  return place;
}

}  // namespace

std::vector<Vector3d> tool_curve(const TraceFile& trace, std::size_t tool_axes, int parts) {
  HermiteCurve curve(parts);
  for (const TraceRow& row : trace.rows)
    curve.add(row.t, first_of(row.q, tool_axes), first_of(row.qd, tool_axes));
  return curve.take();
}

std::vector<Vector3d> tool_curve_of_poses(const TraceFile& trace, int parts) {
  HermiteCurve curve(parts);
  const auto& rows = trace.rows;
  const auto place = [&](std::size_t k) {
    return Vector3d(rows[k].pose[0], rows[k].pose[1], rows[k].pose[2]);
  };
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::size_t before = k == 0 ? 0 : k - 1, after = std::min(k + 1, rows.size() - 1);
    const double T = rows[after].t - rows[before].t;
    const Vector3d velocity =
        T > 0 ? Vector3d((place(after) - place(before)) / T) : Vector3d::Zero();
    curve.add(rows[k].t, place(k), velocity);
  }
  return curve.take();
}

PathDeviation path_deviation(const std::vector<Vector3d>& curve, const ProgrammedPath& path,
                             double window) {
  Follower follower(path.places, window);
  Misses misses(path, follower);
  PathDeviation found;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    found.from_path = std::max(found.from_path, follower.follow(curve[k]));
    misses.pass(curve[k > 0 ? k - 1 : 0], curve[k], follower.range());
  }
  found.miss = *std::max_element(misses.least().begin(), misses.least().end());
  return found;
}

PathExcess path_excess(const std::vector<Vector3d>& curve, const ProgrammedPath& path,
                       const PathBounds& bounds, double window,
                       const std::vector<PathStretch>& where) {
  Follower follower(path.places, window);
  Misses misses(path, follower);
  PathExcess found;
  for (std::size_t k = 0; k < curve.size(); ++k) {
    if (where.empty()) follower.follow(curve[k]);
    const Range range = where.empty() ? follower.range() : misses.range(where[k], window);
    const double excess = follower.excess(curve[k], range, found.from_path, [&](double length) {
      return misses.allowed(bounds, length);
    });
    if (excess > found.from_path) found.from_path = excess, found.place = curve[k];
    misses.pass(curve[k > 0 ? k - 1 : 0], curve[k], range);
  }
  for (std::size_t i = 0; i < bounds.misses.size(); ++i) {
    const double excess = misses.least()[i] - bounds.misses[i];
    if (excess > found.miss) found.miss = excess, found.point = i;
  }
  return found;
}

}  // namespace rob::test
