#include "motion/ahead/guide.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {

namespace {

/// Relative difference below which two squares of rates are the same: rounding of a few operations.
constexpr double kSame = 1e-12;

double root(double square) noexcept { return std::sqrt(std::max(square, 0.0)); }

}  // namespace

bool Guide::at_run_end() const noexcept { return stands() && blocked() && at_ == 0; }

void Guide::restart(PathRing::Index at, const JointVector& q) noexcept {
  index_ = begun_ = first_ = at;
  at_ = rate_ = acceleration_ = 0;
  braking_ = false;
  limit_ = {};
  place_.q = q;
  place_.qd.setZero();
  place_.qdd.setZero();
}

Guide::Part Guide::next_part(double until) noexcept {
  Part part{time_, sigma_, rate_, 0};
  const Piece* const piece = blocked() ? nullptr : ring_.piece(index_);
  const double rest = piece == nullptr ? 0 : piece->length - at_;
  Choice choice;
  if (piece != nullptr && !(braking_ && rate_ == 0)) {
    part.sigma = sigma_ = piece->begin + at_;
    choice =
        piece->straight() && !piece->averaged() ? on_line(*piece, rest) : on_curve(*piece, rest);
  }
  limit_ = choice.limit;
  const double mean = (rate_ + choice.end_rate) / 2;
  if (!(mean > 0)) {  // it stands
    part.rate = rate_ = acceleration_ = 0;
    time_ = until;
    return part;
  }
  part.acceleration = acceleration_ = choice.control;
  const double lasts = choice.way / mean;
  const double left = until - time_;
  if (lasts > left) {
    const double way = std::min((rate_ + acceleration_ * left / 2) * left, choice.way);
    rate_ = std::max(rate_ + acceleration_ * left, 0.0);
    at_ += way;
    time_ = until;
  } else {
    rate_ = choice.end_rate;
    at_ += choice.way;
    time_ += lasts;
  }
  if (choice.way == rest && lasts <= left) {
    ++index_;
    at_ = 0;
    sigma_ = piece->begin + piece->length;
  } else {
    sigma_ = piece->begin + at_;
  }
  return part;
}

/// The greatest σ' on the piece apart from what lies ahead.
double Guide::greatest_rate(const Piece& piece, GuideLimit& limit) const noexcept {
  const double paced = piece.pace * share_;
  if (paced > piece.fastest) {
    limit = {GuideLimit::Kind::Speed, piece.fastest_axis};
    return piece.fastest;
  }
  limit = {share_ < 1 ? GuideLimit::Kind::Override : GuideLimit::Kind::Pace, -1};
  return paced;
}

/// Straight in the axes: σ'' is bounded alike everywhere, and the greatest square that leads to the
/// one at the end falls evenly towards it.
Guide::Choice Guide::on_line(const Piece& piece, double rest) const noexcept {
  const StraightControl control = straight_control(piece);
  const double most = control.most;
  const double x = rate_ * rate_;
  const double end = ring_.square(index_);
  const double line = end + 2 * most * rest;
  Choice choice;
  GuideLimit cruising;
  const double top_rate = greatest_rate(piece, cruising);
  const double top = top_rate * top_rate;
  choice.limit = {GuideLimit::Kind::Acceleration, control.axis};
  if (braking_ || x > top * (1 + kSame)) {
    const double floor = braking_ ? 0 : top;
    choice.control = -most;
    choice.way = std::min(rest, (x - floor) / (2 * most));
    choice.end_rate = choice.way < rest ? std::sqrt(floor) : root(x - 2 * most * rest);
    choice.limit.kind = GuideLimit::Kind::Braking;
  } else if (x >= line * (1 - kSame)) {
    choice.control = (end - x) / (2 * rest);
    choice.way = rest;
    choice.end_rate = std::sqrt(end);
  } else if (x < top * (1 - kSame)) {
    choice.control = most;
    choice.way = std::min((top - x) / (2 * most), (line - x) / (4 * most));
    choice.end_rate = root(x + 2 * most * choice.way);
    if (choice.way >= rest) {
      choice.way = rest;
      choice.end_rate = root(x + 2 * most * rest);
    }
  } else {
    choice.way = std::min(rest, (line - x) / (2 * most));
    choice.end_rate = rate_;
    choice.limit = cruising;
  }
  return choice;
}

/// σ'' from the bounds at this place and at the end of the piece, even up to there.
Guide::Choice Guide::on_curve(const Piece& piece, double rest) const noexcept {
  const PathPoint here = piece.point(at_);
  const PathPoint end = piece.point(piece.length);
  const double x = rate_ * rate_;
  const ControlRange range = control_range(piece, here, end, rest, x);
  const double to_end = (ring_.square(index_) - x) / (2 * rest);
  const double high = std::min(range.high, to_end);
  const double low = std::min(range.low, high);
  GuideLimit cruising;
  const double top_rate = greatest_rate(piece, cruising);
  const double top = top_rate * top_rate;
  Choice choice;
  choice.way = rest;
  choice.limit = {GuideLimit::Kind::Acceleration, range.high_axis};
  if (braking_ || x > top * (1 + kSame)) {
    choice.limit = {GuideLimit::Kind::Braking, range.low_axis};
    choice.control = low;
    if (x + 2 * low * rest < 0)
      choice.control = std::min(-x / (2 * rest), stopping_control(piece, here, end, x));
    const double floor = braking_ ? 0 : top;
    if (choice.control < 0 && x + 2 * choice.control * rest < floor)
      choice.way = (x - floor) / (-2 * choice.control);
  } else if (x < top * (1 - kSame)) {
    choice.control = high;
    if (high > 0) choice.way = std::min(rest, (top - x) / (2 * high));
  } else {
    choice.control = std::clamp(0.0, low, high);
    if (choice.control == 0) choice.limit = cruising;
  }
  choice.end_rate = root(x + 2 * choice.control * choice.way);
  return choice;
}

/// Between two pieces the one that it has left counts: σ'' was chosen on it.
void Guide::update_place() noexcept {
  if (at_ == 0) {
    if (index_ == first_) return;
    const Piece& last = ring_.written(index_ - 1);
    place_ = driven(last.point(last.length), rate_, acceleration_);
    return;
  }
  place_ = driven(ring_.written(index_).point(at_), rate_, acceleration_);
}

}  // namespace rob::motion
