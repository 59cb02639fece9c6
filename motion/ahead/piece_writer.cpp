#include "motion/ahead/piece_writer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/ahead/reachable.h"

namespace rob::motion {

void PieceWriter::begin_run() {
  if (end_ != ring_.end()) publish(false);
  speeds_.begin();
  calm_ = {};
}

void PieceWriter::rest_on_the_way() {
  if (!mean_.of_sigma) return;
  speeds_.end_at_rest();
  publish(false);
  speeds_.begin();
}

void PieceWriter::end_run() {
  if (end_ > 0) ring_.set_run_end(end_ - 1, true);
  speeds_.end_at_rest();
  tail_ = {};
}

void PieceWriter::drop() {
  end_ = ring_.end();
  published_ = -kAny;
  speeds_.begin();
  tail_ = {};
}

std::size_t PieceWriter::room() const noexcept {
  return ring_.room() - static_cast<std::size_t>(end_ - ring_.end());
}

void PieceWriter::write(std::vector<Piece>& pieces) {
  for (Piece& piece : pieces) {
    known_ = piece.begin + piece.length;
    if (piece.begin < calm_.end - kSamePlace) piece.calm_down(calm_.share);
    if (mean_.of_sigma) {
      speeds_.add(piece);
    } else if (extends_last(piece)) {
      Piece& last = ring_.draft(end_ - 1);
      last.length = known_ - last.begin;
      continue;
    }
    ring_.draft(end_) = piece;
    ring_.set_square(end_, 0);
    ring_.set_run_end(end_, false);
    ++end_;
  }
}

/// Straight on from a draft, and bounded alike.
bool PieceWriter::extends_last(const Piece& piece) const {
  if (end_ == ring_.end() || !piece.straight() || mean_.pauses) return false;
  const Piece& last = ring_.written(end_ - 1);
  constexpr double kSame = 1e-12;
  return last.straight() && !last.torqued() && !piece.torqued() && !ring_.run_end(end_ - 1) &&
         last.pace == piece.pace && last.acceleration == piece.acceleration &&
         (last.terms[1] - piece.terms[1]).cwiseAbs().maxCoeff() <= kSame;
}

void PieceWriter::calm_down(double from, double to, double share) {
  PathRing::Index first = end_;
  while (first > ring_.end() && !ring_.run_end(first - 1)) --first;
  for (PathRing::Index i = first; i < end_; ++i) {
    const Piece& piece = ring_.written(i);
    if (piece.begin + piece.length <= from + kSamePlace) continue;
    if (piece.begin < from - kSamePlace && piece.straight()) {
      split(i, from);
      continue;
    }
    ring_.draft(i).calm_down(share);
  }
  const bool overlaps = calm_.end > from;
  calm_ = {std::max(calm_.end, to), overlaps ? std::min(calm_.share, share) : share};
}

/// A straight draft into two.
void PieceWriter::split(PathRing::Index at, double sigma) noexcept {
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

bool PieceWriter::guide_within(double time, double deceleration) const {
  const double rate = ring_.rate.load(std::memory_order_relaxed);
  const double rest = published_ - ring_.sigma.load(std::memory_order_relaxed);
  if (rate == 0) return rest <= 1e-9 * (1 + std::abs(known_));
  if (deceleration == kAny) return 2 * rest <= rate * time;
  return rest <= rate * rate / (2 * deceleration) + rate * time;
}

bool PieceWriter::work(double share) {
  const bool anew = share != std::exchange(share_, share);
  if (!anew && end_ == ring_.end()) return false;
  publish(anew);
  return true;
}

/// The pieces before this one can be run: what acts together with them is known.
PathRing::Index PieceWriter::ready() {
  if (end_ == 0 || ring_.run_end(end_ - 1)) return end_;
  if (mean_.of_sigma) {
    if (!speeds_.grown() && !guide_within(kSoon, tail_.control)) return ring_.end();
    speeds_.plan(mean_.time);
    return ring_.end() + speeds_.ready();
  }
  return tail_.held == 0 ? end_ : sure_to(tail_.end - tail_.held);
}

/// Those that end before σ; what goes on straight across it is split there.
PathRing::Index PieceWriter::sure_to(double sigma) {
  PathRing::Index first = ring_.end();
  for (PathRing::Index unsure = end_; first < unsure;) {
    const PathRing::Index middle = first + (unsure - first) / 2;
    const Piece& piece = ring_.written(middle);
    if (piece.begin + piece.length <= sigma + kSamePlace) {
      first = middle + 1;
    } else {
      unsure = middle;
    }
  }
  if (first == end_ || room() == 0) return first;
  const Piece& across = ring_.written(first);  // straight on, each leg makes it longer
  if (across.straight() && across.begin < sigma - kSamePlace) split(first++, sigma);
  return first;
}

bool PieceWriter::narrow() {
  if (!guide_within(kLastChance, kAny)) return false;  // it makes room
  if (tail_.held > 0 && !more_to_publish() && end_ > ring_.end()) {
    let_go();  // the corner then calms what is left
    return true;
  }
  if (!mean_.of_sigma || end_ < ring_.end() + 2 || ready() != ring_.end()) return false;
  const Piece& first = ring_.written(ring_.end());
  const double known = known_ - first.begin;
  const double reach = std::min(known / 2, (known - first.length) * 0.999);
  const double fastest = 2 * reach / mean_.time;
  for (PathRing::Index i = ring_.end(); i < end_; ++i) {
    Piece& piece = ring_.draft(i);
    if (piece.fastest <= fastest) continue;
    piece.fastest = fastest;
    piece.fastest_axis = -1;
  }
  speeds_.limit(fastest);
  return true;
}

void PieceWriter::publish(bool anew) {
  const PathRing::Index until = ready();
  if (mean_.of_sigma && until > ring_.end()) bound_speeds(until);
  for (PathRing::Index i = ring_.end(); listener_ != nullptr && i < until; ++i)
    listener_->planned(ring_.written(i));
  const bool more = until > ring_.end();
  pass_back(until, anew);
  if (!more) return;
  const Piece& last = ring_.written(until - 1);
  published_ = last.begin + last.length;
}

/// Gives each piece before `until` the bounds of all within reach of it.
void PieceWriter::bound_speeds(PathRing::Index until) {
  speeds_.plan(mean_.time);
  for (PathRing::Index i = ring_.end(); i < until; ++i) {
    Piece& piece = ring_.draft(i);
    const SpeedPlan::Stretch& stretch = speeds_.stretch(static_cast<std::size_t>(i - ring_.end()));
    const Extent& most = mean_.alone ? stretch.own : stretch.most;
    const auto axes = piece.acceleration.size();
    piece.slopes = most.slopes.head(axes);
    piece.bends = most.bends.head(axes);
    if (piece.torqued()) {
      piece.torque.slope = most.slopes[Extent::kTorque];
      piece.torque.bend = most.bends[Extent::kTorque];
    }
    piece.swings = (mean_.alone ? most.slopes : most.swings).head(axes);
    if (mean_.alone) continue;
    if (most.fastest < piece.fastest) {
      piece.fastest = most.fastest;
      piece.fastest_axis = most.fastest_axis;
    }
    if (stretch.rate >= piece.fastest) continue;
    piece.fastest = stretch.rate;
    piece.fastest_axis = -1;
  }
  speeds_.fix(static_cast<std::size_t>(until - ring_.end()));
}

/// From the end backwards: new pieces first, which are then published, and those before until
/// nothing changes.
void PieceWriter::pass_back(PathRing::Index ready, bool anew) {
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

double PieceWriter::top_square(const Piece& piece) const noexcept {
  const double top = piece.greatest_rate(share_);
  return top * top;
}

}  // namespace rob::motion
