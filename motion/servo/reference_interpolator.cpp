#include "motion/servo/reference_interpolator.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/space/quintic.h"

namespace rob::motion {
namespace {

// Stamps are whole multiples of the period, computed in floating point.
constexpr double kStampTolerance = 1e-6;  // of a period

bool is_finite(const JointReference& reference) noexcept {
  return std::isfinite(reference.time) && reference.q.allFinite() && reference.qd.allFinite() &&
         reference.qdd.allFinite();
}

JointReference back_from(const JointReference& reference, double now) noexcept {
  const double t = now - reference.time;
  JointReference before = reference;
  before.time = now;
  before.q += reference.qd * t + reference.qdd * (0.5 * t * t);
  before.qd += reference.qdd * t;
  return before;
}

}  // namespace

ReferenceInterpolator::ReferenceInterpolator(double period, const JointVector& v_max,
                                             const JointVector& a_max, const JointVector& j_max)
    : period_(period), extrapolation_(period, v_max, a_max), join_(v_max, a_max, j_max) {}

void ReferenceInterpolator::reset(const JointReference& stand) noexcept {
  first_ = 0;
  count_ = 1;
  ring_[0] = stand;
  ring_[0].qd.setZero(stand.q.size());
  ring_[0].qdd.setZero(stand.q.size());
  extrapolating_ = false;
  last_ = stand.time;
  join_.clear();
}

// The stand is dated back by more than a curve connects, and counts as extrapolated since.
void ReferenceInterpolator::rejoin(const JointReference& stand) noexcept {
  reset(stand);
  ring_[0].time -= (kLongestGap + 1) * period_;
  begin_extrapolation();
  extrapolating_ = true;
}

bool ReferenceInterpolator::push(const JointReference& reference) noexcept {
  assert(count_ > 0 && "reset() comes first");
  if (!is_finite(reference) || reference.time <= kept(count_ - 1).time) return false;
  if (count_ == kKept) drop_oldest();
  ring_[static_cast<std::size_t>((first_ + count_) % kKept)] = reference;
  ++count_;
  return true;
}

void ReferenceInterpolator::join_from(const JointReference& found) noexcept {
  join_.start(found, without_join(found.time));
}

JointReference ReferenceInterpolator::at(double now) noexcept {
  JointReference reference = without_join(now);
  join_.apply(reference);
  return reference;
}

JointReference ReferenceInterpolator::without_join(double now) noexcept {
  assert(count_ > 0 && "reset() comes first");
  while (extrapolating_ && count_ > 1 && !next_is_far(now)) return_at(return_instant(now));
  drop_passed(now);
  const bool goes_on = must_extrapolate(now);
  if (goes_on && !extrapolating_) begin_extrapolation();
  extrapolating_ = goes_on;
  if (goes_on) count_starvation(now);
  last_ = now;

  return goes_on ? extrapolation_.at(now) : on_references(now);
}

const JointReference& ReferenceInterpolator::kept(int i) const noexcept {
  return ring_[static_cast<std::size_t>((first_ + i) % kKept)];
}

void ReferenceInterpolator::drop_oldest() noexcept {
  first_ = (first_ + 1) % kKept;
  --count_;
}

void ReferenceInterpolator::drop_passed(double now) noexcept {
  while (count_ > 1 && kept(1).time <= now) drop_oldest();
}

bool ReferenceInterpolator::gap_follows() const noexcept {
  return count_ > 1 && kept(1).time - kept(0).time > (kLongestGap + kStampTolerance) * period_;
}

// After a gap, and too early to take up.
bool ReferenceInterpolator::next_is_far(double now) const noexcept {
  return gap_follows() && now < kept(1).time - (1 + kStampTolerance) * period_;
}

bool ReferenceInterpolator::must_extrapolate(double now) const noexcept {
  return now > kept(0).time && (count_ == 1 || next_is_far(now));
}

JointReference ReferenceInterpolator::on_references(double now) const noexcept {
  if (now <= kept(0).time) return kept(0);
  if (gap_follows()) return back_from(kept(1), now);
  return quintic_between(kept(0), kept(1), now);
}

void ReferenceInterpolator::begin_extrapolation() noexcept {
  extrapolation_.start(kept(0));
  starved_here_ = 0;
}

// When the way back begins: at what was sent last, for what was never sent is no difference; or as
// soon after it as the references are known.
double ReferenceInterpolator::return_instant(double now) const noexcept {
  double start = std::max(last_, kept(0).time);
  if (gap_follows()) start = std::max(start, kept(1).time - period_);
  return std::min(start, now);
}

void ReferenceInterpolator::return_at(double start) noexcept {
  JointReference sent = extrapolation_.at(start);
  join_.apply(sent);
  drop_passed(start);
  extrapolating_ = must_extrapolate(start);
  if (extrapolating_) begin_extrapolation();
  join_.start(sent, extrapolating_ ? extrapolation_.at(start) : on_references(start));
}

void ReferenceInterpolator::count_starvation(double now) noexcept {
  if (extrapolation_.at_rest()) return;
  const double periods = (now - extrapolation_.base().time) / period_;
  const auto missing = static_cast<std::uint64_t>(std::floor(periods + 0.5));
  if (missing <= starved_here_) return;
  starved_ += missing - starved_here_;
  starved_here_ = missing;
}

}  // namespace rob::motion
