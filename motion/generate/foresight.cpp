#include "motion/generate/foresight.h"

#include <algorithm>
#include <cmath>

#include "motion/generate/guide_history.h"

namespace rob::motion {

namespace {

/// When a guide that goes on as it is passes `sigma`, not after `until`.
std::optional<double> guide_passes(Guide guide, double sigma, double until) noexcept {
  std::optional<double> found;
  Guide::Part before{guide.time(), guide.sigma(), guide.rate(), guide.acceleration()};
  guide.step(until, [&](const Guide::Part& part) noexcept {
    if (!found && part.sigma >= sigma) found = passing_time(before, sigma, part.time);
    before = part;
  });
  if (!found && guide.sigma() >= sigma) found = passing_time(before, sigma, until);
  return found;
}

}  // namespace

Foresight::Foresight(const Guide& guide, const ReferenceAverage& average, double period)
    : guide_(guide), average_(average), period_(period), samples_(ReferenceAverage::kMost) {}

/// The mean at a later period. The first guide has left some of its samples.
ReferenceMark Foresight::begin_mean(const ReferenceMark& now, Guide& second, int period) noexcept {
  const int periods = average_.periods();
  ReferenceMark sum;
  for (int i = 0; i < periods; ++i) {
    const int at = period - periods + 1 + i;
    if (at > 0) second.step(now.time + at * period_, [](const Guide::Part&) noexcept {});
    GuideState& sample = samples_[static_cast<std::size_t>(i)];
    sample = at > 0 ? GuideState{second.sigma(), second.rate()} : average_.past(-at);
    sum.sigma += sample.sigma - now.sigma;
    sum.rate += sample.rate;
  }
  oldest_ = 0;
  return {now.time + period * period_, now.sigma + sum.sigma / periods, sum.rate / periods};
}

/// A mean over N periods moves by an Nth of the difference between the new sample and the oldest,
/// which leaves it.
ReferenceMark Foresight::next_mean(const ReferenceMark& last, Guide& second) noexcept {
  const int periods = average_.periods();
  const double time = last.time + period_;
  second.step(time, [](const Guide::Part&) noexcept {});
  GuideState& sample = samples_[static_cast<std::size_t>(oldest_)];
  const GuideState leaves = sample;
  sample = {second.sigma(), second.rate()};
  oldest_ = oldest_ + 1 == periods ? 0 : oldest_ + 1;
  return {time, last.sigma + (sample.sigma - leaves.sigma) / periods,
          last.rate + (sample.rate - leaves.rate) / periods};
}

/// If the mean will pass the place later than `within`, it does not look again for half of the
/// difference, unless the guide will pass sooner than before.
std::optional<double> Foresight::when(const ReferenceMark& now, const Place& place,
                                      Outlook& outlook) noexcept {
  const double until = now.time + std::min(place.within, kFurthest);
  const auto passes = guide_passes(guide_, place.sigma, until + period_);
  if (!passes) return std::nullopt;
  const bool as_before = *passes > outlook.guide_passes - period_ / 2;
  if (now.time < outlook.again && as_before) return std::nullopt;
  const double there = look(now, place.sigma, *passes);
  if (there <= until) return there;
  outlook = {*passes, now.time + (there - until) / 2};
  return std::nullopt;
}

/// When the mean passes a place that the guide passes at `passes`.
double Foresight::look(const ReferenceMark& now, double sigma, double passes) noexcept {
  const int before = static_cast<int>(std::floor((passes - now.time) / period_)) - 1;
  Guide second = guide_;
  ReferenceMark last = begin_mean(now, second, std::max(before, 0));
  for (int i = 0; i < average_.periods() + 2; ++i) {
    const ReferenceMark next = next_mean(last, second);
    if (reaches(next, sigma)) return passing_time(last, next, sigma);
    last = next;
  }
  return last.time;
}

}  // namespace rob::motion
