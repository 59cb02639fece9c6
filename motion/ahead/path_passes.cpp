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

Extent PathPlanner::extent_of(const Piece& piece) const noexcept {
  const PathPoint begin = piece.point(0);
  const PathPoint end = piece.point(piece.length);
  Extent extent;
  const auto axes = piece.acceleration.size();
  extent.slopes.head(axes) = begin.qd.cwiseAbs().cwiseMax(end.qd.cwiseAbs());
  extent.bends.head(axes) = begin.qdd.cwiseAbs().cwiseMax(end.qdd.cwiseAbs());
  extent.asked = std::sqrt(top_square(piece)) * std::max(1.0, 1 / share_);
  extent.fastest = piece.fastest;
  extent.fastest_axis = piece.fastest_axis;
  // q = q(σ) has the jerk q'''·σ'³ + 3·q''·σ'·σ'' + q'·σ'''. Piece::fastest leaves to the first
  // what kBendsShare says. Of the mean, |σ'''| <= 2·u/T where |σ''| <= u: with σ'' so small that
  // (|q'| + 1.5·T·|q''|·σ')·u <= A, the others take 2A/T, which is the rest.
  double square = extent.asked * extent.asked;
  for (int i = 0; i < axes; ++i) square = std::min(square, piece.acceleration[i] / extent.bends[i]);
  extent.swings = extent.slopes + 1.5 * window_ * std::sqrt(square) * extent.bends;
  return extent;
}

/// σ' that the speeds of the axes leave all along a leg.
double PathPlanner::axes_rate(const ShapedLeg& leg) const {
  double least = kAny;
  for (const double share : {0.0, 0.5, 1.0}) {
    const PathPoint place = leg.at(share * leg.length());
    for (int i = 0; i < robot_.axis_count(); ++i)
      least =
          std::min(least, robot_.axes[static_cast<std::size_t>(i)].v_max / std::abs(place.qd[i]));
  }
  return least;
}

/// Of a leg that is opened.
void PathPlanner::note_rate(const ShapedLeg& leg) {
  if (leg.starts) {
    run_begin_ = leg.begin;
    fastest_ = 0;
    slowest_ = kAny;
  }
  const double rate = axes_rate(leg);
  fastest_ = std::max(fastest_, std::min(leg.segment.ahead.speed, rate));
  if (rate > slowest_ && leg.begin - slow_end_ <= fastest_ * mean_time() / 2) return;
  slowest_ = rate;
  slow_end_ = leg.end();
}

/// Where the mean is of σ, the axes of a leg bound what is passed within half its time of it:
/// whether that costs more than a stop, which separates them.
bool PathPlanner::crawls_beside(const ShapedLeg& leg, const ShapedLeg& next) const {
  const double mean = mean_time();
  const double most = axes_rate(next);
  const double rate = std::min(next.segment.ahead.speed, most);
  const double behind = std::min(fastest_ * mean / 2, leg.end() - run_begin_);
  const double ahead = std::clamp(rate * mean / 2 - (leg.end() - slow_end_), 0.0, next.length());
  double lost = 0;
  if (most < fastest_) lost += behind * (1 / most - 1 / fastest_);
  if (slowest_ < rate) lost += ahead * (1 / slowest_ - 1 / rate);
  const PathPoint end = leg.at(leg.length());
  const double brakes = greatest_rate(robot_, leg, end) / (2 * greatest_control(leg, end));
  const double gains = rate / (2 * greatest_control(next, next.at(0)));
  return lost > mean + brakes + gains;
}

/// The pieces before this one can be run: what acts together with them is known.
PathRing::Index PathPlanner::ready() const noexcept {
  if (end_ == 0 || ring_.run_end(end_ - 1)) return end_;
  double sure = known_ - outlook_;
  if (!averages_sigma()) {
    if (held_ == 0 || !open_ || completing_) return end_;
    sure = open_->end() - held_ * (1 - 1e-12);
  }
  PathRing::Index first = ring_.end();
  for (PathRing::Index unsure = end_; first < unsure;) {
    const PathRing::Index middle = first + (unsure - first) / 2;
    const Piece& piece = ring_.written(middle);
    if (piece.begin + piece.length <= sure) {
      first = middle + 1;
    } else {
      unsure = middle;
    }
  }
  return first;
}

/// Around the corner to come, of the drafts of its run behind and of all that is written from here
/// on; false where the ring is full.
bool PathPlanner::calm_corner() {
  const double middle = open_->end();
  const double from = middle - turn_->calm_way;
  if (!send(std::max(open_->sent, from - open_->begin))) return false;
  const double share = turn_->calm;
  PathRing::Index first = end_;
  while (first > ring_.end() && !ring_.run_end(first - 1)) --first;
  for (PathRing::Index i = first; i < end_; ++i) {
    const Piece& piece = ring_.written(i);
    if (piece.begin + piece.length <= from + kRounding) continue;
    if (piece.begin < from - kRounding && piece.straight()) {
      split(i, from);
      continue;
    }
    ring_.draft(i).calm_down(share);
  }
  const bool overlaps = calm_.end > from;
  calm_ = {std::max(calm_.end, middle + turn_->calm_way),
           overlaps ? std::min(calm_.share, share) : share};
  turn_->calm = 1;  // that is done
  return true;
}

/// A straight draft into two.
void PathPlanner::split(PathRing::Index at, double sigma) noexcept {
  for (PathRing::Index i = end_; i > at; --i) {
    ring_.draft(i) = ring_.written(i - 1);
    ring_.set_square(i, 0);
    ring_.set_run_end(i, false);
  }
  ++end_;
  Piece& first = ring_.draft(at);
  Piece& second = ring_.draft(at + 1);
  second.terms[0] += second.terms[1] * (sigma - second.begin);
  second.length -= sigma - second.begin;
  first.length = sigma - first.begin;
  second.begin = sigma;
}

/// Whether it stands at the end of what is known, or would `time` after braking so hard; where it
/// brakes along the path already: whether it will stand so soon.
bool PathPlanner::guide_within(double time, double deceleration) const {
  const double rate = ring_.rate.load(std::memory_order_relaxed);
  const double rest = published_ - ring_.sigma.load(std::memory_order_relaxed);
  if (rate == 0) return rest <= 1e-9 * (1 + std::abs(known_));
  if (deceleration == kAny) return 2 * rest <= rate * time;
  return rest <= rate * rate / (2 * deceleration) + rate * time;
}

/// Nothing more fits, and no draft can be published: they are made so slow that half of them can,
/// or the first.
bool PathPlanner::narrow() noexcept {
  if (!guide_within(kLastChance, kAny)) return false;  // it makes room
  if (held_ > 0 && !more_to_publish() && end_ > ring_.end()) {
    held_ = 0;  // the corner then calms what is left
    return true;
  }
  if (!averages_sigma() || end_ < ring_.end() + 2 || ready() != ring_.end()) return false;
  const Piece& first = ring_.written(ring_.end());
  outlook_ = std::min((known_ - first.begin) / 2, (known_ - first.begin - first.length) * 0.999);
  const double fastest = 2 * outlook_ / window_;
  for (PathRing::Index i = ring_.end(); i < end_; ++i) {
    Piece& piece = ring_.draft(i);
    if (piece.fastest <= fastest) continue;
    piece.fastest = fastest;
    extents_.limit_asked(i, fastest);
    piece.fastest_axis = -1;
  }
  return true;
}

/// The greatest of all pieces of its run around this one that the guide can be on while the mean is
/// on this: from a mean over T of speeds up to v no place is farther than v·T/2.
void PathPlanner::spread(PathRing::Index at) noexcept {
  Piece& piece = ring_.draft(at);
  const PathRing::Index lowest = std::max(ring_.begin(), extents_.run(at));
  Extent most = extents_.of(at);
  PathRing::Index first = at;
  PathRing::Index last = at;
  for (double reach = -1; reach < most.asked * window_ / 2;) {
    reach = most.asked * window_ / 2;
    first = extents_.last_before(piece.begin - reach, lowest, first);
    last = extents_.last_up_to(piece.begin + piece.length + reach, last, end_);
    most.asked = extents_.greatest_asked(first, last);
  }
  most.take(extents_.greatest(first, last));
  const auto axes = piece.acceleration.size();
  piece.slopes = most.slopes.head(axes);
  piece.bends = most.bends.head(axes);
  piece.swings = most.swings.head(axes);
  if (most.fastest >= piece.fastest) return;
  piece.fastest = most.fastest;
  piece.fastest_axis = most.fastest_axis;
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
