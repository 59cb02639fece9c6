#include "motion/generate/place_events.h"

#include <algorithm>
#include <cmath>

#include "motion/space/cycle_instant.h"

namespace rob::motion {

void PlaceEvents::expect(const PathEvent& event, double sigma, double earliest) noexcept {
  if (count_ < kMost)
    entries_[count_++] = {sigma, event.lead, earliest, false, 0, {}, event.effect};
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
    if (entry.passed || !reaches(now_, entry.sigma)) continue;
    entry.passed = true;
    entry.when = passing(entry.sigma);
  }
}

/// When the references passed its place, or will within its lead from now on.
std::optional<double> PlaceEvents::when(Entry& entry) noexcept {
  if (!entry.passed && reaches(now_, entry.sigma)) {  // before it was expected
    entry.passed = true;
    entry.when = passing(entry.sigma);
  }
  if (entry.passed) return entry.when;
  if (entry.lead <= 0) return std::nullopt;
  return foresight_.when(now_, {entry.sigma, entry.lead}, entry.outlook);
}

/// An event at the motion's beginning cannot keep its lead; what was foreseen too late comes now.
void PlaceEvents::remember(const Entry& entry, double due) noexcept {
  if (cut_ > 0 || led_count_ == kMost) return;
  const double came = due > before_.time ? due : now_.time;
  led_[led_count_++] = {entry.effect.tag, entry.sigma, entry.lead, came};
}

std::optional<PlaceEvents::Missed> PlaceEvents::take_missed(double tolerance) noexcept {
  for (std::size_t i = 0; i < led_count_;) {
    const Led led = led_[i];
    if (!reaches(now_, led.sigma)) {
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

const Effect* PlaceEvents::take(const Until& until, double& due) noexcept {
  std::size_t first = kMost;
  double wanted = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    Entry& entry = entries_[i];
    if (entry.effect.after > until.number) continue;
    const auto passes = when(entry);
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
