#include "motion/generate/guide_history.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {

namespace {

double after(const Guide::Part& part, double time) noexcept {
  const double t = std::max(time - part.time, 0.0);
  return part.sigma + (part.rate + part.acceleration * t / 2) * t;
}

bool stands(const Guide::Part& part) noexcept { return part.rate == 0 && part.acceleration == 0; }

}  // namespace

double passing_time(const Guide::Part& part, double sigma, double end) noexcept {
  const double left = std::max(sigma - part.sigma, 0.0);
  const double square = part.rate * part.rate + 2 * part.acceleration * left;
  const double sum = part.rate + std::sqrt(std::max(square, 0.0));
  return sum > 0 ? std::min(part.time + 2 * left / sum, end) : end;
}

void GuideHistory::begin(double time, double sigma) noexcept {
  first_ = count_ = 0;
  keep({time, sigma, 0, 0});
}

void GuideHistory::keep(const Guide::Part& part) noexcept {
  if (stands(part)) {
    if (count_ > 0 && stands(this->part(count_ - 1))) return;
    standing_ = part.time;
  }
  if (count_ == kMost) {
    first_ = (first_ + 1) % kMost;
    --count_;
  }
  parts_[(first_ + count_) % kMost] = part;
  ++count_;
}

void GuideHistory::forget(double time) noexcept {
  while (count_ > 1 && part(1).time <= time) {
    first_ = (first_ + 1) % kMost;
    --count_;
  }
}

double GuideHistory::sigma(double time) const noexcept {
  std::size_t i = 0;
  while (i + 1 < count_ && part(i + 1).time <= time) ++i;
  const bool inside = i + 1 < count_;
  const double here = after(part(i), time);
  return inside ? std::min(here, part(i + 1).sigma) : here;
}

std::optional<double> GuideHistory::when(double sigma, double until) const noexcept {
  for (std::size_t i = 0; i < count_ && part(i).time <= until; ++i) {
    const Guide::Part& p = part(i);
    if (p.sigma >= sigma) return p.time;
    const double end = i + 1 < count_ ? std::min(part(i + 1).time, until) : until;
    if (after(p, end) < sigma) continue;
    return passing_time(p, sigma, end);
  }
  return std::nullopt;
}

}  // namespace rob::motion
