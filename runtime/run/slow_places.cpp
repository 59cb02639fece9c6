#include "runtime/run/slow_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "motion/generate/limit_numbers.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

constexpr double kSame = 1e-9;  // relative: rates that differ by less are one

/// The share of its limit from which on an axis is what holds the speed. The mean that bounds the
/// jerk flattens an acceleration that lasts for less than its time.
constexpr double kAtLimit = 0.95;
constexpr double kNoticeable = 0.3;

/// [choice] rad, 11°: there the axes of a singular place turn five times as fast as elsewhere.
constexpr double kNear = 0.2;

/// m that the corner at the end of a leg may take of it, where it turns by 60° or more: it misses
/// the target by a quarter of its half times |e2 − e1| (docs/motion.md).
double corner_of(const motion::LegBounds& bounds) {
  return std::min({4 * bounds.miss, bounds.lead, bounds.share / 2 * bounds.length});
}

}  // namespace

void SlowPlaces::begin(const LoggedSegment& segment) {
  begun_ = Leg{static_cast<int>(segment.tag), segment.ahead};
}

void SlowPlaces::take(const motion::GeneratorSample& sample, double way) {
  constexpr double kTurning = 0.01;  // of σ': where the tool turns on the spot it is less
  constexpr double kStands = 1e-6;   // m/s: rounding of a mean
  const std::optional<Leg>& leg = begun_ ? begun_ : leg_;
  const bool along = leg && leg->bounds.length > 0;
  Passed next{sample, along && sample.state == motion::MotionState::Running};
  next.moves =
      next.moves && sample.rate > kStands && way > kTurning * sample.rate * robot_.reference_period;
  judge(next);
  if (begun_) {
    close_leg();
    corner_behind_ = leg_ ? corner_of(leg_->bounds) : 0;
    corner_judged_ = leg_ && leg_->worst && leg_->worst->corner;
    leg_ = std::move(begun_);
    begun_.reset();
  }
  if (leg_ && next.moves) leg_->most = std::max(leg_->most, sample.rate);
  before_ = last_;
  last_ = next;
}

/// Whether the last reference was where the speed was least.
void SlowPlaces::judge(const Passed& next) {
  if (!leg_ || !before_.moves || !last_.moves || !next.moves) return;
  const double rate = last_.sample.rate * (1 - kSame);
  if (before_.sample.rate < rate || next.sample.rate < rate) return;
  if (leg_->worst && leg_->worst->speed <= last_.sample.rate * kMillimetresPerMetre) return;
  SlowPlace place = describe();
  if (corner_judged_ && last_.sample.sigma <= corner_behind_) return;
  find_cause(next, place);
  leg_->worst = place;
}

SlowPlace SlowPlaces::describe() const {
  const motion::GeneratorSample& sample = last_.sample;
  const double length = leg_->bounds.length;
  SlowPlace place;
  place.line = leg_->tag;
  place.time = sample.reference.time;
  place.at = std::clamp(sample.sigma, 0.0, length) * kMillimetresPerMetre;
  place.speed = sample.rate * kMillimetresPerMetre;
  const double step = sample.rate * robot_.reference_period;  // the least speed lies in between
  place.corner = sample.sigma <= corner_behind_ + step ||
                 sample.sigma >= length - corner_of(leg_->bounds) - step;
  place.near = robot_.kinematics->nearest_singularity(sample.reference.q, kNear);
  return place;
}

/// The axis that is nearest to its limit there.
void SlowPlaces::find_cause(const Passed& next, SlowPlace& place) const {
  double speed = 0;
  double pull = 0;
  int fastest = 0;
  int hardest = 0;
  for (int i = 0; i < robot_.axis_count(); ++i) {
    const motion::Axis& axis = axis_of(robot_, i);
    const double v = std::abs(last_.sample.reference.qd[i]) / axis.v_max;
    double a = 0;
    for (const Passed* passed : {&before_, &last_, &next})
      a = std::max(a, std::abs(passed->sample.reference.qdd[i]));
    a /= axis.a_max * leg_->bounds.acceleration;
    if (v > speed) fastest = i;
    if (a > pull) hardest = i;
    speed = std::max(speed, v);
    pull = std::max(pull, a);
  }
  if (last_.sample.limit == motion::limit_number::kEndOfBuffer) {
    place.cause = SlowPlace::Cause::EndOfPath;
  } else if (speed < kAtLimit && pull < kNoticeable && leg_->bounds.window > 0) {
    place.cause = SlowPlace::Cause::Jerk;
  } else {
    const bool at_speed = speed >= kAtLimit;
    place.cause = at_speed ? SlowPlace::Cause::Speed : SlowPlace::Cause::Acceleration;
    place.axis = axis_of(robot_, at_speed ? fastest : hardest).name;
  }
}

void SlowPlaces::close_leg() {
  if (!leg_ || !leg_->worst) return;
  SlowPlace& place = *leg_->worst;
  place.asked = (leg_->bounds.paced ? leg_->bounds.speed : leg_->most) * kMillimetresPerMetre;
  const auto share = [](const SlowPlace& one) { return one.speed / one.asked; };
  if (share(place) >= kSlow || (place.corner && !leg_->bounds.paced)) return;
  const auto same = std::ranges::find(worst_, place.line, &SlowPlace::line);
  if (same == worst_.end()) {
    worst_.push_back(place);
  } else if (share(place) < share(*same)) {
    *same = place;
  }
  const auto rank = [&](const SlowPlace& one) {
    return std::pair(std::round(share(one) * 1e6), one.line);
  };
  std::ranges::sort(worst_, {}, rank);
  if (worst_.size() > kMost) worst_.pop_back();
}

std::string cause_of(const SlowPlace& place) {
  constexpr std::array kNearTo{"", " near the wrist singularity", " near the shoulder singularity",
                               " with the arm nearly stretched or folded",
                               " near a singular posture"};
  const char* const near_to = kNearTo.at(static_cast<std::size_t>(place.near));
  switch (place.cause) {
    case SlowPlace::Cause::Speed:
      return fmt::format("axis {} speed{}", place.axis, near_to);
    case SlowPlace::Cause::Acceleration:
      return fmt::format("axis {} acceleration{}", place.axis, near_to);
    case SlowPlace::Cause::Jerk:
      return fmt::format("the jerk of the axes{}", near_to);
    case SlowPlace::Cause::EndOfPath:
      break;
  }
  return "what follows was not known in time";
}

std::vector<SlowPlace> SlowPlaces::finish() {
  close_leg();
  return std::move(worst_);
}

}  // namespace rob::runtime
