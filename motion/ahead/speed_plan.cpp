#include "motion/ahead/speed_plan.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "motion/ahead/path_shape.h"

namespace rob::motion {

namespace {

/// So far an override can raise the pace, of path that has been planned already.
constexpr double kMostRaised = 2;

/// [choice] Above the rate that is planned, so that what holds the guide is an axis and not this.
constexpr double kAbove = 1.002;

/// Calls take(node) for nodes that together have the leaves first … last below them, and no others.
template <typename Take>
void cover(std::size_t leaves, std::size_t first, std::size_t last, Take&& take) {
  std::size_t from = leaves + first;
  for (std::size_t to = leaves + last + 1; from < to; from /= 2, to /= 2) {
    if (from % 2 == 1) take(from++);
    if (to % 2 == 1) take(--to);
  }
}

}  // namespace

void Extent::take(const Extent& its) noexcept {
  slopes = slopes.max(its.slopes);
  bends = bends.max(its.bends);
  swings = swings.max(its.swings);
  if (its.fastest >= fastest) return;
  fastest = its.fastest;
  fastest_axis = its.fastest_axis;
}

void SpeedPlan::begin(double square) {
  stretches_.clear();
  fixed_ = ready_ = 0;
  rests_ = false;
  entry_ = square;
  promise_ = {};
  stale_ = true;
  planned_ = 0;
}

void SpeedPlan::add(const Piece& piece) {
  const PathPoint begin = piece.point(0);
  const PathPoint end = piece.point(piece.length);
  const auto axes = piece.acceleration.size();
  Stretch stretch;
  stretch.begin = piece.begin;
  stretch.length = piece.length;
  stretch.pace = piece.pace;
  stretch.top = std::min(piece.fastest, piece.pace * kMostRaised);
  if (piece.begin < promise_.until) stretch.top = std::min(stretch.top, promise_.rate);
  stretch.own.slopes.head(axes) = begin.qd.cwiseAbs().cwiseMax(end.qd.cwiseAbs());
  stretch.own.bends.head(axes) = begin.qdd.cwiseAbs().cwiseMax(end.qdd.cwiseAbs());
  if (piece.torqued()) {
    stretch.own.slopes[Extent::kTorque] = piece.torque.slope;
    stretch.own.bends[Extent::kTorque] = piece.torque.bend;
  }
  for (const double at : {0.0, piece.length / 2, piece.length})
    stretch.jolts.head(axes) =
        stretch.jolts.head(axes).max(third_derivative(piece, at).array().abs());
  stretch.own.fastest = piece.fastest;
  stretch.own.fastest_axis = piece.fastest_axis;
  stretch.acceleration.setOnes();
  stretch.acceleration.head(axes) = piece.acceleration;
  stretches_.push_back(stretch);
  stale_ = true;
}

void SpeedPlan::limit(double rate) noexcept {
  for (std::size_t i = fixed_; i < stretches_.size(); ++i)
    stretches_[i].top = std::min(stretches_[i].top, rate);
  stale_ = true;
}

void SpeedPlan::end_at_rest() noexcept { rests_ = stale_ = true; }

void SpeedPlan::plan(double average) {
  if (!std::exchange(stale_, false) && average == average_) return;
  average_ = average;
  planned_ = open();
  const std::size_t count = stretches_.size();
  ready_ = 0;
  if (fixed_ == count) return;
  bounds_.resize(count);
  squares_.resize(count + 1);
  // From the speeds of each place alone the slow places are spread far, from the result not far
  // enough, and so on; what is spread as far as the third and is no faster is right.
  bound_by_own(average);
  pass();
  take_rates(1);
  constexpr int kRounds = 2;
  for (int round = 0; round < kRounds; ++round) {
    spread(average);
    pass();
    take_rates(1);
  }
  for (std::size_t i = fixed_; i < count; ++i)
    bounds_[i].square = stretches_[i].rate * stretches_[i].rate;
  spread(average);
  for (std::size_t i = fixed_; i < count; ++i)
    bounds_[i].square = std::min(bounds_[i].square, stretches_[i].rate * stretches_[i].rate);
  pass();
  take_rates(kAbove);
  spread(average);
}

/// q = q(σ) has the jerk q'''·σ'³ + 3·q''·σ'·σ'' + q'·σ'''. With the mean, |σ'''| <= 2·u/T where
/// |σ''| <= u; with T = 2A/J that is at most
///
///     q'''·σ'³ + (|q'| + 1.5·T·|q''|·σ')·2u/T <= 2A/T
///
/// No faster is the mean than the bends here allow to all within reach, nor than any of that.
static Extent with_swings(const SpeedPlan::Stretch& stretch, double rate, double average) noexcept {
  constexpr double kLeast = 0.01;  // of the acceleration: more is left (kBendsShare)
  Extent extent = stretch.own;
  const double square = std::min({rate * rate, extent.fastest * extent.fastest,
                                  (stretch.acceleration / extent.bends).minCoeff()});
  const double root = std::sqrt(square);
  const Extent::Axes left = 1 - average / 2 * square * root * stretch.jolts / stretch.acceleration;
  extent.swings = (extent.slopes + 1.5 * average * root * extent.bends) / left.max(kLeast);
  if (extent.slopes[Extent::kTorque] > 0) extent.swings[Extent::kTorque] = 0;
  return extent;
}

void SpeedPlan::bound_by_own(double average) {
  for (std::size_t i = fixed_; i < stretches_.size(); ++i) {
    const Stretch& stretch = stretches_[i];
    bounds_[i].extent = with_swings(stretch, stretch.top, average);
    bounds_[i].square =
        std::min(stretch.top * stretch.top, (stretch.acceleration / stretch.own.bends).minCoeff());
  }
}

/// σ'' that all axes allow in either direction.
double SpeedPlan::control(std::size_t at, double square) const noexcept {
  constexpr double kNoSlope = 1e-30;
  const Extent& extent = bounds_[at].extent;
  const Extent::Axes& most = stretches_[at].acceleration;
  const double along = ((most - square * extent.bends) / (extent.slopes + kNoSlope)).minCoeff();
  return std::max(0.0, std::min(along, (most / (extent.swings + kNoSlope)).minCoeff()));
}

/// σ'² where the stretches meet: forwards what can be reached, backwards from where the end can be.
void SpeedPlan::pass() {
  const std::size_t count = stretches_.size();
  squares_[fixed_] = std::min(entry_, bounds_[fixed_].square);
  for (std::size_t i = fixed_; i < count; ++i) {
    const double cap =
        std::min(bounds_[i].square, i + 1 < count ? bounds_[i + 1].square : bounds_[i].square);
    const double x = squares_[i];
    squares_[i + 1] = std::min(cap, x + 2 * stretches_[i].length * control(i, x));
  }
  if (rests_) squares_[count] = 0;
  for (std::size_t i = count; i > fixed_; --i) {
    const double x = squares_[i];
    squares_[i - 1] =
        std::min(squares_[i - 1], x + 2 * stretches_[i - 1].length * control(i - 1, x));
  }
}

/// σ'² between the ends of a stretch at most.
double SpeedPlan::peak(std::size_t at) const noexcept {
  const double a = squares_[at];
  const double b = squares_[at + 1];
  const double gains = control(at, std::min(a, b)) * stretches_[at].length;
  return std::min(bounds_[at].square, (a + b) / 2 + gains);
}

void SpeedPlan::take_rates(double more) noexcept {
  for (std::size_t i = fixed_; i < stretches_.size(); ++i) {
    Stretch& stretch = stretches_[i];
    stretch.rate = std::min(stretch.top, more * std::sqrt(peak(i)));
  }
}

double SpeedPlan::time() {
  for (std::size_t i = fixed_; i < stretches_.size(); ++i) {
    const double top = std::min(stretches_[i].rate, stretches_[i].pace);
    bounds_[i].square = std::min(bounds_[i].square, top * top);
  }
  pass();
  double time = 0;
  for (std::size_t i = fixed_; i < stretches_.size(); ++i) {
    const double a = squares_[i];
    const double b = squares_[i + 1];
    const double length = stretches_[i].length;
    const double top = std::sqrt(peak(i));
    const double u = control(i, std::min(a, b));
    const double changes = u > 0 ? (2 * top * top - a - b) / (2 * u) : 0;
    if (changes > 0 && changes <= length * (1 + 1e-9)) {
      time += (2 * top - std::sqrt(a) - std::sqrt(b)) / u + (length - changes) / top;
    } else {
      time += 2 * length / (std::sqrt(a) + std::sqrt(b));
    }
  }
  return time;
}

/// The bounds that each stretch keeps, of all that is within reach at the rates there are now.
void SpeedPlan::spread(double average) {
  lay_out_times();
  find_reach(average);
  build_rates();
  build_extents(average);
  for (std::size_t i = fixed_; i < stretches_.size(); ++i) {
    Stretch& stretch = stretches_[i];
    stretch.most = greatest(stretch.first, stretch.last);
    bounds_[i].extent = stretch.most;
    const double bent = (stretch.acceleration / stretch.most.bends).minCoeff();
    const double top = std::min(stretch.top, stretch.most.fastest);
    bounds_[i].square = std::min(top * top, bent);
  }
}

/// Places count from the beginning of the first stretch.
void SpeedPlan::lay_out_times() {
  const std::size_t count = stretches_.size();
  const double zero = stretches_[0].begin;
  times_.resize(count + 1);
  integrals_.resize(count + 1);
  times_[0] = integrals_[0] = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Stretch& stretch = stretches_[i];
    const double takes = stretch.length / stretch.rate;
    times_[i + 1] = times_[i] + takes;
    integrals_[i + 1] = integrals_[i] + (stretch.begin - zero + stretch.length / 2) * takes;
  }
}

/// The integral of the place of a guide that always has the rate c. Before the first stretch it
/// stands; after the last one it does, too, or goes on at the same rate. `at`: a stretch that
/// begins no later.
double SpeedPlan::place_integral(double time, std::size_t& at) const noexcept {
  if (time <= 0) return 0;
  const Stretch& last = stretches_.back();
  if (time >= times_.back()) {
    const double more = time - times_.back();
    const double end = last.begin + last.length - stretches_[0].begin;
    return integrals_.back() + more * (end + (rests_ ? 0 : last.rate * more / 2));
  }
  while (times_[at + 1] <= time) ++at;
  const Stretch& stretch = stretches_[at];
  const double more = time - times_[at];
  return integrals_[at] + more * (stretch.begin - stretches_[0].begin + stretch.rate * more / 2);
}

/// The one on which that place lies, m from the beginning of the first, from `at` on.
void SpeedPlan::go_to(double place, std::size_t& at) const noexcept {
  const double sigma = stretches_[0].begin + place;
  while (at + 1 < stretches_.size() && stretches_[at + 1].begin <= sigma) ++at;
}

/// With the guide on a stretch the mean lies no farther before and after it than what has been gone
/// at c in the mean of a time T. Ready are those of which that is known.
void SpeedPlan::find_reach(double average) {
  const std::size_t count = stretches_.size();
  const double zero = stretches_[0].begin;
  const double end = stretches_.back().begin + stretches_.back().length - zero;
  Cursors at;
  ready_ = 0;
  for (std::size_t i = fixed_; i < count; ++i) {
    Stretch& stretch = stretches_[i];
    double back = stretch.begin - zero;
    double ahead = back + stretch.length;
    if (average > 0) {
      const double before = place_integral(times_[i] - average, at.before);
      const double after = place_integral(times_[i + 1] + average, at.after);
      back = (integrals_[i] - before) / average;
      ahead = (after - integrals_[i + 1]) / average;
    }
    go_to(back, at.first);
    go_to(ahead, at.last);
    stretch.first = std::min(i, at.first);
    stretch.last = std::max(i, at.last);
    if (ready_ == i - fixed_ && (rests_ || ahead <= end)) ++ready_;
  }
}

void SpeedPlan::build_rates() {
  const std::size_t count = stretches_.size();
  leaves_ = std::bit_ceil(count);
  rates_.assign(2 * leaves_, 0);
  for (std::size_t i = 0; i < count; ++i) rates_[leaves_ + i] = stretches_[i].rate;
  for (std::size_t i = leaves_ - 1; i > 0; --i)
    rates_[i] = std::max(rates_[2 * i], rates_[2 * i + 1]);
}

void SpeedPlan::build_extents(double average) {
  const std::size_t count = stretches_.size();
  extents_.assign(2 * leaves_, Extent());
  for (std::size_t i = 0; i < count; ++i) {
    const Stretch& stretch = stretches_[i];
    extents_[leaves_ + i] =
        with_swings(stretch, greatest_rate(stretch.first, stretch.last), average);
  }
  for (std::size_t i = leaves_ - 1; i > 0; --i) {
    extents_[i] = extents_[2 * i];
    extents_[i].take(extents_[2 * i + 1]);
  }
}

double SpeedPlan::greatest_rate(std::size_t first, std::size_t last) const noexcept {
  double most = 0;
  cover(leaves_, first, last, [&](std::size_t node) { most = std::max(most, rates_[node]); });
  return most;
}

Extent SpeedPlan::greatest(std::size_t first, std::size_t last) const noexcept {
  Extent most;
  cover(leaves_, first, last, [&](std::size_t node) { most.take(extents_[node]); });
  return most;
}

/// Where what is ready has looked beyond the end, what follows must be no faster than was thought.
void SpeedPlan::promise(std::size_t fixed) noexcept {
  if (rests_) return;
  const double beyond = times_[fixed] + average_ - times_.back();
  if (beyond <= 0) return;
  const Stretch& last = stretches_.back();
  const double end = last.begin + last.length;
  const double until = end + last.rate * beyond;
  const bool holds = promise_.until > end;
  promise_ = {holds ? std::min(promise_.rate, last.rate) : last.rate,
              holds ? std::max(promise_.until, until) : until};
}

void SpeedPlan::fix(std::size_t count) {
  if (count == 0) return;
  const std::size_t end = fixed_ + count;
  promise(end);
  // [choice] what the mean can be on within T, and what that was reckoned with
  const double looked_at = times_[end] + 2 * average_;
  for (std::size_t i = end; i < stretches_.size() && times_[i] < looked_at; ++i)
    stretches_[i].top = stretches_[i].rate;
  entry_ = squares_[end];
  fixed_ = end;
  ready_ -= std::min(ready_, count);
  stale_ = true;
  planned_ = open();
  trim();
}

/// Those that nothing to come can reach are forgotten.
void SpeedPlan::trim() {
  const double sure = times_[fixed_] - average_;
  std::size_t past = 0;
  while (past < fixed_ && times_[past + 1] < sure) ++past;
  if (past < 64 || 2 * past < fixed_) return;  // [choice] seldom
  stretches_.erase(stretches_.begin(), stretches_.begin() + static_cast<std::ptrdiff_t>(past));
  for (Stretch& stretch : stretches_) {
    stretch.first -= std::min(stretch.first, past);
    stretch.last -= std::min(stretch.last, past);
  }
  fixed_ -= past;
}

}  // namespace rob::motion
