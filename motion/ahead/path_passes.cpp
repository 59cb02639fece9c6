// What the PathPlanner publishes: pieces, what acts together with them, and how fast they may be.

#include <algorithm>
#include <cmath>

#include "motion/ahead/path_planner.h"
#include "motion/ahead/reachable.h"

namespace rob::motion {

/// Straight on from a draft, and bounded alike.
bool PathPlanner::extends_last(const Piece& piece) const {
  if (end_ == ring_.end() || !piece.straight()) return false;
  const Piece& last = ring_.written(end_ - 1);
  constexpr double kSame = 1e-12;
  return last.straight() && !ring_.run_end(end_ - 1) && last.pace == piece.pace &&
         last.acceleration == piece.acceleration &&
         (last.terms[1] - piece.terms[1]).cwiseAbs().maxCoeff() <= kSame;
}

double PathPlanner::top_square(const Piece& piece) const noexcept {
  const double top = piece.greatest_rate(share_);
  return top * top;
}

PathPlanner::Extent PathPlanner::extent_of(const Piece& piece) const noexcept {
  const PathPoint begin = piece.point(0);
  const PathPoint end = piece.point(piece.length);
  return {begin.qd.cwiseAbs().cwiseMax(end.qd.cwiseAbs()),
          begin.qdd.cwiseAbs().cwiseMax(end.qdd.cwiseAbs()),
          std::sqrt(top_square(piece)) * std::max(1.0, 1 / share_)};
}

/// The pieces before this one can be run: what acts together with them is known.
PathRing::Index PathPlanner::ready() const noexcept {
  PathRing::Index at = end_;
  if (!averages_sigma() || at == 0 || ring_.run_end(at - 1)) return at;
  while (at > ring_.end()) {
    const Piece& piece = ring_.written(at - 1);
    if (piece.begin + piece.length <= known_ - reach_) break;
    --at;
  }
  return at;
}

/// The greatest of all pieces within reach_ of this one in its run. For its speed those count that
/// may be as near in time as half of the mean's, which is the longer the slower they have to be.
void PathPlanner::spread(PathRing::Index at) noexcept {
  Piece& piece = ring_.draft(at);
  Extent most = extent(at);
  JointVector fast = most.slopes;
  double left = 0;
  const auto take = [&](PathRing::Index other) {
    most.slopes = most.slopes.cwiseMax(extent(other).slopes);
    most.bends = most.bends.cwiseMax(extent(other).bends);
    if (left < 0) return;
    fast = fast.cwiseMax(extent(other).slopes);
    left -= ring_.written(other).length / extent(other).fastest;
  };
  left = window_ / 2;
  for (PathRing::Index i = at; i > ring_.begin() && !ring_.run_end(i - 1); --i) {
    if (ring_.written(i).begin < piece.begin - reach_) break;
    take(i - 1);
  }
  left = window_ / 2;
  for (PathRing::Index i = at; i + 1 < end_ && !ring_.run_end(i); ++i) {
    if (ring_.written(i + 1).begin > piece.begin + piece.length + reach_) break;
    take(i + 1);
  }
  piece.slopes = most.slopes;
  piece.bends = most.bends;
  bound_speed(robot_, fast, piece);
}

void PathPlanner::publish(bool anew) {
  const PathRing::Index until = ready();
  if (averages_sigma()) {
    for (PathRing::Index i = ring_.end(); i < until; ++i) spread(i);
  }
  for (PathRing::Index i = ring_.end(); listener_ != nullptr && i < until; ++i)
    listener_->planned(ring_.written(i));
  pass_back(until, anew);
  if (until == 0) return;
  const Piece& last = ring_.written(until - 1);
  published_ = last.begin + last.length;
}

/// From the end backwards: new pieces first, which are then published, and those before until
/// nothing changes.
void PathPlanner::pass_back(PathRing::Index ready, bool anew) {
  const PathRing::Index first_new = ring_.end();
  double square = 0;
  bool cut = ready > 0 && !ring_.run_end(ready - 1);
  if (ready > 0) ring_.set_cut(ready - 1, cut);
  for (PathRing::Index i = ready; i > ring_.begin() + 1; --i) {
    const Piece& piece = ring_.written(i - 1);
    const Piece& before = ring_.written(i - 2);
    const double cap = std::min(top_square(piece), top_square(before));
    const bool rests = ring_.run_end(i - 2);
    square = rests ? 0 : reachable_square(piece, square, cap);
    cut = cut && !rests && square < cap;
    const bool same = square == ring_.square(i - 2) && cut == ring_.cut(i - 2);
    if (i - 1 < first_new && !anew && same) break;
    if (i - 1 == first_new) ring_.publish(ready);
    ring_.set_cut(i - 2, cut);
    ring_.set_square(i - 2, square);
  }
  ring_.publish(ready);
}

}  // namespace rob::motion
