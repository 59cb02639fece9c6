#include "drivers/encoder.h"

#include <cmath>

namespace rob::drivers {
namespace {

// Below this share of a count the filter is at rest. Without it the estimate would decay for ever,
// into denormal numbers that cost a hundred times the cycles.
constexpr double kAtRest = 1e-6;

}  // namespace

Encoder::Encoder(double resolution) : resolution_(resolution) {
  const double p = std::exp(-kBandwidth * kPeriod);
  alpha_ = 1 - p * p;
  beta_ = (1 - p) * (1 - p);
}

double Encoder::position(double q) const noexcept {
  return std::nearbyint(q / resolution_) * resolution_;
}

void Encoder::sample(double q) noexcept {
  const double count = position(q);
  const double r = count - (x_ + v_ * kPeriod);
  x_ = count - (1 - alpha_) * r;
  v_ += beta_ * r / kPeriod;
  const double rest = kAtRest * resolution_;
  if (std::abs(r) < rest && std::abs(v_) * kPeriod < rest) settle(count, 0);
}

void Encoder::settle(double q, double v) noexcept {
  x_ = position(q);
  v_ = v;
}

}  // namespace rob::drivers
