#include "motion/generate/place_events.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

}  // namespace

void PlaceEvents::expect(const PathEvent& event, double sigma, double earliest) noexcept {
  if (count_ < kMost) entries_[count_++] = {sigma, event.lead, earliest, false, 0, event.effect};
}

/// What comes at the motion's beginning cannot keep its lead; what was foreseen too late comes now.
void PlaceEvents::remember(const Entry& entry, double due, double now) noexcept {
  if (due > entry.when - entry.lead || led_count_ == kMost) return;
  led_[led_count_++] = {entry.effect.tag, entry.sigma, entry.lead, due > before_ ? due : now};
}

std::optional<PlaceEvents::Missed> PlaceEvents::take_missed(const GuideHistory& history, double now,
                                                            double lag, double tolerance) noexcept {
  for (std::size_t i = 0; i < led_count_;) {
    const Led led = led_[i];
    const auto when = history.when(led.sigma, now - lag);
    if (!when) {
      ++i;
      continue;
    }
    led_[i] = led_[--led_count_];
    const double error = *when + lag - led.lead - led.came;
    if (std::abs(error) > tolerance) return Missed{led.tag, *when + lag, error};
  }
  return std::nullopt;
}

const Effect* PlaceEvents::take(const Guide& guide, const GuideHistory& history, double now,
                                double lag, double& due) noexcept {
  if (now > looked_) before_ = std::exchange(looked_, now);
  std::size_t first = kMost;
  for (std::size_t i = 0; i < count_; ++i) {
    Entry& entry = entries_[i];
    std::optional<double> when;
    if (!entry.passed) {
      when = history.when(entry.sigma, now);
      entry.passed = when.has_value();
      const double ahead = std::min(entry.lead - lag, kFurthest);
      if (!when && ahead > 0) when = foreseen(guide, entry.sigma, now + ahead);
      if (when) entry.when = *when + lag;
    }
    if (!entry.passed && !when) continue;
    const double at = std::max(entry.earliest, entry.when - entry.lead);
    if (at > now || (first < kMost && at >= due)) continue;
    due = at;
    first = i;
  }
  if (first == kMost) return nullptr;
  taken_ = entries_[first].effect;
  if (!entries_[first].passed) remember(entries_[first], due, now);
  std::move(entries_.begin() + static_cast<std::ptrdiff_t>(first) + 1,
            entries_.begin() + static_cast<std::ptrdiff_t>(count_),
            entries_.begin() + static_cast<std::ptrdiff_t>(first));
  --count_;
  return &taken_;
}

}  // namespace rob::motion
