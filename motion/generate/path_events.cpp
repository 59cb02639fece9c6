#include "motion/generate/path_events.h"

#include <algorithm>

namespace rob::motion {

namespace {

/// h in 0 … 1 at which the part of a leg that lies in its corner has been passed up to `share` of
/// the corner's end: S1's polynomial from rest, 2h³ − h⁴, grows from 0 to 1.
double corner_place(double share) noexcept {
  double low = 0;
  double high = 1;
  for (int i = 0; i < 50; ++i) {  // 50 halvings: below 1e-15
    const double h = (low + high) / 2;
    ((2 - h) * h * h * h < share ? low : high) = h;
  }
  return high;
}

}  // namespace

void PathEvents::begin(const SegmentDescriptor& leg, double zero, double t_before, bool from_rest,
                       double instant, double rate) noexcept {
  leg_zero_ = zero;
  leg_duration_ = leg.duration;
  leg_ = leg.number;
  for (const PathEvent& event : leg.on_the_way) {
    if (count_ == kMost) return;
    const double share = std::clamp(event.share, 0.0, 1.0);
    double t = leg.profile.present() ? leg.profile.time_at(share) : share * leg.duration;
    if (!leg.profile.present() && from_rest && t < t_before)
      t = (2 * corner_place(t / t_before) - 1) * t_before;
    const double shift = event.lead * rate;
    const double wish = zero + t - shift;
    const double cut = shift > 0 ? std::max(instant - wish, 0.0) : 0;
    entries_[count_++] = {std::max(instant, wish), share, shift, cut, event.effect};
  }
}

void PathEvents::stop(double t_acc) noexcept {
  for (std::size_t i = 0; i < count_; ++i) {
    Entry& entry = entries_[i];
    const double left = (1 - entry.share) * leg_duration_;
    if (left >= t_acc || entry.effect.after != leg_) continue;
    const double t = (1 - 2 * corner_place(left / t_acc)) * t_acc;
    const double wish = leg_zero_ + leg_duration_ + t - entry.shift;
    entry.cut = std::max(entry.cut - std::max(wish - (entry.due - entry.cut), 0.0), 0.0);
    entry.due = std::max(entry.due, wish);
  }
}

const Effect* PathEvents::take(double path_time, std::uint32_t number, double& due) noexcept {
  const auto end = entries_.begin() + static_cast<std::ptrdiff_t>(count_);
  auto first = end;
  for (auto entry = entries_.begin(); entry != end; ++entry) {
    if (entry->effect.after > number || entry->due > path_time) continue;
    if (first == end || entry->due < first->due) first = entry;
  }
  if (first == end) return nullptr;
  taken_ = first->effect;
  cut_ = first->cut;
  due = first->due;
  std::move(first + 1, end, first);
  --count_;
  return &taken_;
}

}  // namespace rob::motion
