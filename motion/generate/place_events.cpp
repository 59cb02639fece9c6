#include "motion/generate/place_events.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/generate/segment_generator.h"

namespace rob::motion {

namespace {

/// When a guide that goes on as it is passes `sigma`, not after `until`.
std::optional<double> foreseen(Guide guide, double sigma, double until) noexcept {
  std::optional<double> found;
  Guide::Part before{guide.time(), guide.sigma(), guide.rate(), guide.acceleration()};
  guide.step(until, [&](const Guide::Part& part) noexcept {
    if (!found && part.sigma >= sigma) found = passing_time(before, sigma, part.time);
    before = part;
  });
  if (!found && guide.sigma() >= sigma) found = passing_time(before, sigma, until);
  return found;
}

/// σ on the cubic through both marks, at a share of their time.
double between(const PlaceEvents::Mark& a, const PlaceEvents::Mark& b, double share) noexcept {
  const double T = b.time - a.time;
  const double left = 1 - share;
  return a.sigma + share * share * (3 - 2 * share) * (b.sigma - a.sigma) +
         share * left * T * (left * a.rate - share * b.rate);
}

}  // namespace

void PlaceEvents::expect(const PathEvent& event, double sigma, double earliest) noexcept {
  if (count_ < kMost) entries_[count_++] = {sigma, event.lead, earliest, false, 0, event.effect};
}

void PlaceEvents::begin_run(const Mark& mark) noexcept {
  before_ = now_ = mark;
  led_count_ = 0;
}

void PlaceEvents::go_on(const Mark& mark) noexcept {
  before_ = now_;
  now_ = mark;
  for (std::size_t i = 0; i < count_; ++i) {
    Entry& entry = entries_[i];
    if (entry.passed || !reached(entry.sigma)) continue;
    entry.passed = true;
    entry.when = passing(entry.sigma);
  }
}

/// But for the rounding of sums of lengths.
bool PlaceEvents::reached(double sigma) const noexcept {
  return now_.sigma >= sigma - 1e-12 * (1 + std::abs(sigma));
}

double PlaceEvents::passing(double sigma) const noexcept {
  if (before_.sigma >= sigma) return before_.time;
  double low = 0;
  double high = 1;
  for (int i = 0; i < 50; ++i) {  // 50 halvings: below 1e-15
    const double middle = (low + high) / 2;
    (between(before_, now_, middle) < sigma ? low : high) = middle;
  }
  return before_.time + high * (now_.time - before_.time);
}

std::optional<double> PlaceEvents::when(Entry& entry, const Guide& guide,
                                        const GuideHistory& history, double lag) const noexcept {
  if (!entry.passed && reached(entry.sigma)) {  // before it was expected
    entry.passed = true;
    entry.when = passing(entry.sigma);
  }
  if (entry.passed) return entry.when;
  if (entry.lead <= 0) return std::nullopt;
  const double ahead = std::min(entry.lead - lag, kFurthest);
  auto passes = history.when(entry.sigma, now_.time);
  if (!passes && ahead > 0) passes = foreseen(guide, entry.sigma, now_.time + ahead);
  // Half of the mean's time after the guide; but they have not been there by now.
  return passes ? std::optional(std::max(*passes + lag, now_.time)) : std::nullopt;
}

/// What comes at the motion's beginning cannot keep its lead; what was foreseen too late comes now.
void PlaceEvents::remember(const Entry& entry, double due) noexcept {
  if (cut_ > 0 || led_count_ == kMost) return;
  const double came = due > before_.time ? due : now_.time;
  led_[led_count_++] = {entry.effect.tag, entry.sigma, entry.lead, came};
}

std::optional<PlaceEvents::Missed> PlaceEvents::take_missed(double tolerance) noexcept {
  for (std::size_t i = 0; i < led_count_;) {
    const Led led = led_[i];
    if (!reached(led.sigma)) {
      ++i;
      continue;
    }
    led_[i] = led_[--led_count_];
    const double when = passing(led.sigma);
    const double error = when - led.lead - led.came;
    if (std::abs(error) > tolerance) return Missed{led.tag, when, error};
  }
  return std::nullopt;
}

const Effect* PlaceEvents::take(const Guide& guide, const GuideHistory& history, double lag,
                                const Until& until, double& due) noexcept {
  std::size_t first = kMost;
  double wanted = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    Entry& entry = entries_[i];
    if (entry.effect.after > until.number) continue;
    const auto passes = when(entry, guide, history, lag);
    if (!passes) continue;
    const double wish = *passes - entry.lead;
    double at = std::max(entry.earliest, wish);
    if (entry.passed && entry.lead >= 0) at = std::min(at, until.time);
    if (at > until.time + kSameInstant || (first < kMost && at >= due)) continue;
    due = at;
    wanted = wish;
    first = i;
  }
  if (first == kMost) return nullptr;
  const Entry& entry = entries_[first];
  taken_ = entry.effect;
  cut_ = entry.lead > 0 ? due - wanted : 0;
  if (!entry.passed) remember(entry, due);
  std::move(entries_.begin() + static_cast<std::ptrdiff_t>(first) + 1,
            entries_.begin() + static_cast<std::ptrdiff_t>(count_),
            entries_.begin() + static_cast<std::ptrdiff_t>(first));
  --count_;
  return &taken_;
}

}  // namespace rob::motion
