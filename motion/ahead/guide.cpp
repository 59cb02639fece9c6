#include "motion/ahead/guide.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {

namespace {

/// Relative difference below which two squares of rates are the same: rounding of a few operations.
constexpr double kSame = 1e-12;

/// The same of a square that has come out of a long division.
constexpr double kNear = 1e-9;

/// The rounding of a place on a piece, and of the rest of it: some times that of one operation.
constexpr double kRounding = 1e-15;

double root(double square) noexcept { return std::sqrt(std::max(square, 0.0)); }

}  // namespace

bool Guide::at_run_end() const noexcept { return stands() && blocked() && at_ == 0; }

void Guide::restart(PathRing::Index at, const JointVector& q) noexcept {
  index_ = begun_ = first_ = at;
  at_ = rate_ = acceleration_ = 0;
  pause_ = 0;
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
  if (time_ < start_) {
    choice.until = start_;
  } else if (piece != nullptr && !(braking_ && rate_ == 0)) {
    part.sigma = sigma_ = piece->begin + at_;
    choice = pause_ > 0 ? choose_alone(*piece, rest) : choose(*piece, rest);
  }
  limit_ = choice.limit;
  const double mean = (rate_ + choice.end_rate) / 2;
  if (piece == nullptr || !(mean > 0)) {  // it stands
    part.rate = rate_ = acceleration_ = 0;
    time_ = std::min(until, choice.until);
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
  if (acceleration_ > 0) gained_ = time_;
  if (acceleration_ < 0) {
    lost_ = time_;
    lost_on_ = index_;
  }
  if ((choice.way == rest && lasts <= left) || at_ >= piece->length) {
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
  const double top = std::min(piece.greatest_rate(share_), pace_ * share_);
  if (share_ < 1) {
    limit = {GuideLimit::Kind::Override, -1};
  } else if (top == piece.fastest) {
    limit = {GuideLimit::Kind::Speed, piece.fastest_axis};
  } else {
    limit = {GuideLimit::Kind::Pace, -1};
  }
  return top;
}

/// As fast as the bounds here and at the end of the piece allow, until it must be braked: where the
/// axes can brake evenly from here on, the greatest square falls evenly towards the end's.
Guide::Choice Guide::choose(const Piece& piece, double rest) const noexcept {
  const Stretch on{piece.point(at_), piece.point(piece.length), rest, rate_ * rate_};
  const ControlRange range = control_range(piece, on.here, on.end, rest, on.x);
  GuideLimit cruising;
  const double top_rate = greatest_rate(piece, cruising);
  const double top = top_rate * top_rate;
  if (braking_ || on.x > top * (1 + kSame)) return slow_down(piece, on, range, braking_ ? 0 : top);

  const double end = ring_.square(index_);
  // Slow enough for half of what the axes have, they can brake evenly wherever they are on it; else
  // one even σ'' must lead to the end.
  const double half = half_bent(piece, on.end);
  const bool slow = on.x <= half && end <= half;
  const double most = slow ? std::min(top, half) : top;
  const double brakes = slow ? brakes_on(piece, on.end, most) : 0;
  const double line = slow ? end + 2 * brakes * rest : 0;
  Choice choice{range.high, rest, 0, {GuideLimit::Kind::Acceleration, range.high_axis}};
  // Nearer to the line than places on the piece lie apart is on it.
  const double apart = 2 * brakes * (kRounding * piece.length);
  const bool brakes_now = on.x >= line * (1 - kSame) || (on.x > 0 && on.x >= line - apart);
  if (brakes_now) {
    // Above the square, as after a lowered override, as hard as the axes can.
    choice.control = std::min(range.high, std::max(range.lowest, (end - on.x) / (2 * rest)));
    if (ring_.cut(index_)) choice.limit = {GuideLimit::Kind::EndOfPath, -1};
  } else if (on.x >= most * (1 - kSame)) {
    choice.control = std::clamp(0.0, std::min(range.low, range.high), range.high);
    if (choice.control == 0) choice.limit = cruising;
  }
  if (!brakes_now && choice.control + brakes > 0)
    choice.way = std::min(rest, (line - on.x) / (2 * (choice.control + brakes)));
  if (on.x < most * (1 - kSame) && choice.control > 0)
    choice.way = std::min(choice.way, (most - on.x) / (2 * choice.control));
  const double after = on.x + 2 * choice.control * choice.way;
  // Rounding of large numbers that cancel must not leave a speed where the path ends.
  const bool meets_end = choice.way == rest && std::abs(after - end) <= kNear * on.x;
  choice.end_rate = root(meets_end ? end : after);
  return choice;
}

/// The greatest square at which the bends of a piece leave half of the axes' acceleration.
double Guide::half_bent(const Piece& piece, const PathPoint& end) const noexcept {
  const PathPoint begin = piece.point(0);
  double square = Piece::kAny;
  for (int i = 0; i < piece.acceleration.size(); ++i) {
    const double bend =
        piece.averaged() ? piece.bends[i] : std::max(std::abs(begin.qdd[i]), std::abs(end.qdd[i]));
    if (2 * bend * square > piece.acceleration[i]) square = piece.acceleration[i] / (2 * bend);
  }
  if (2 * piece.torque.bend * square > 1) square = 1 / (2 * piece.torque.bend);
  return square;
}

/// The same for all of the piece, so that the square from which it must be braked is one line.
double Guide::brakes_on(const Piece& piece, const PathPoint& end, double top) const noexcept {
  const PathPoint begin = piece.point(0);
  const double before = index_ == first_ ? 0 : ring_.square(index_ - 1);
  const double rise = 2 * piece.length * even_braking(piece, begin, end, 0);
  return even_braking(piece, begin, end,
                      std::min(top, std::max(before, ring_.square(index_)) + rise));
}

/// With the least control, until the square is down to `floor` or the piece ends. Where a bend asks
/// for speed the guide takes it on as far as the end of the path stays in reach; where that was
/// lowered meanwhile, as far as the axes need.
Guide::Choice Guide::slow_down(const Piece& piece, const Stretch& on, const ControlRange& range,
                               double floor) const noexcept {
  const bool ends = on.x + 2 * range.low * on.rest >= 0;  // before it stands
  const double least = ends ? range.low : -on.x / (2 * on.rest);
  const double even = -even_braking(piece, on.here, on.end, on.x);
  const double in_reach = (ring_.square(index_) - on.x) / (2 * on.rest);
  Choice choice{range.low > 0 ? std::min(range.low, std::max({even, in_reach, range.lowest}))
                              : std::min(least, even),
                on.rest,
                0,
                {GuideLimit::Kind::Braking, range.low_axis}};
  const double after = on.x + 2 * choice.control * on.rest;
  choice.end_rate = root(after);
  if (after < floor || after <= 0) {
    choice.way = std::min(on.rest, (on.x - floor) / (-2 * choice.control));
    choice.end_rate = std::sqrt(floor);
  }
  return choice;
}

/// The rate at which speeding up must end: after a pause what is left is just enough to brake,
///     (v² − σ'²)/2u + v·pause + v²/2u = rest
double Guide::peak_rate(double control, double rest) const noexcept {
  const double square = control * rest + rate_ * rate_ / 2;
  const double lost = control * pause_ / 2;
  return square / (lost + std::sqrt(lost * lost + square));
}

/// A pause that is due always has its place: speeding up has left it, and with even speed, or less,
/// it stays.
Guide::Choice Guide::choose_alone(const Piece& piece, double rest) const noexcept {
  constexpr double kPaused = 1e-10;  // s: rounding of the run's time
  GuideLimit cruising;
  const double top = greatest_rate(piece, cruising);
  const StraightControl straight = straight_control(piece);
  const GuideLimit at_axis{GuideLimit::Kind::Acceleration, straight.axis};
  const double brakes = rate_ * rate_ / (2 * straight.most);
  // Nearer to where it brakes than places on the piece lie apart is there.
  if (brakes >= rest * (1 - kSame) - kRounding * piece.length)
    return {-rate_ * rate_ / (2 * rest), rest, 0, at_axis};

  const bool slows = braking_ || rate_ > top * (1 + kSame);
  const double resumes =
      slows ? gained_ + pause_ : lost_ + (lost_on_ == index_ ? pause_ : piece.wait);
  const double peak = slows ? 0 : std::min(top, peak_rate(straight.most, rest));
  const bool gains = peak > rate_ * (1 + kNear);
  if ((slows || gains) && resumes > time_ + kPaused) {
    const double way = std::min(rate_ * (resumes - time_), rest - brakes);
    return {0, way, rate_, slows ? GuideLimit{GuideLimit::Kind::Braking, -1} : at_axis, resumes};
  }
  if (slows) {
    const double floor = braking_ ? 0 : top;
    return {-straight.most,
            brakes - floor * floor / (2 * straight.most),
            floor,
            {GuideLimit::Kind::Braking, straight.axis}};
  }
  if (gains) return {straight.most, peak * peak / (2 * straight.most) - brakes, peak, at_axis};
  return {0, rest - brakes, rate_, rate_ >= top * (1 - kNear) ? cruising : at_axis};
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
