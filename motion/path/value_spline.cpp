#include "motion/path/value_spline.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rob::motion {

/// The second derivatives M from  h₋·M₋ + 2(h₋ + h₊)·M + h₊·M₊ = 6·(slope₊ − slope₋), eliminated
/// from front to back.
ValueSpline::ValueSpline(std::vector<double> places, std::vector<double> values)
    : places_(std::move(places)), values_(std::move(values)), bends_(values_.size(), 0) {
  const std::size_t n = values_.size();
  std::vector<double> upper(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = places_[i] - places_[i - 1];
    const double after = places_[i + 1] - places_[i];
    const double turn =
        6 * ((values_[i + 1] - values_[i]) / after - (values_[i] - values_[i - 1]) / before);
    const double pivot = 2 * (before + after) - before * upper[i - 1];
    upper[i] = after / pivot;
    bends_[i] = (turn - before * bends_[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) bends_[i] -= upper[i] * bends_[i + 1];
}

double ValueSpline::at(double place) const noexcept {
  const auto next = std::upper_bound(places_.begin() + 1, places_.end() - 1, place);
  const auto i = static_cast<std::size_t>(next - places_.begin()) - 1;
  const double h = places_[i + 1] - places_[i];
  const double b = (place - places_[i]) / h;
  const double a = 1 - b;
  const double even = a * values_[i] + b * values_[i + 1];
  const double scale = h * h / 6;
  // The slope at an end less that of the chord, without the bend there, which is 0.
  if (b < 0) return even - b * scale * bends_[i + 1];
  if (a < 0) return even - a * scale * bends_[i];
  return even + ((a * a * a - a) * bends_[i] + (b * b * b - b) * bends_[i + 1]) * scale;
}

}  // namespace rob::motion
