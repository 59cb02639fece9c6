#include "drivers/contact/force_sensor.h"

#include <algorithm>
#include <stdexcept>

namespace rob::drivers {

namespace {

// s. Sums of whole periods reach an instant a rounding error early or late.
constexpr double kSameInstant = 1e-9;

Eigen::Vector3d noise_of(Noise& noise, double deviation) noexcept {
  const double x = noise.normal();
  const double y = noise.normal();
  const double z = noise.normal();
  return deviation * Eigen::Vector3d(x, y, z);
}

}  // namespace

ForceSensor::ForceSensor(const motion::SensorErrors& errors, double delay, std::uint64_t seed)
    : errors_(errors), delay_(delay), noise_(seed) {
  if (!(errors.period > 0)) throw std::invalid_argument("ForceSensor: no period");
  if (!(delay >= 0 && delay < (kSamples - 2) * errors.period))
    throw std::invalid_argument("ForceSensor: remembers fewer samples than the delay is long");
}

void ForceSensor::clear() noexcept {
  taken_ = 0;
  fault_ = Fault::None;
}

void ForceSensor::take(double time, const motion::Wrench& acting) noexcept {
  if (fault_ == Fault::Silent) return;
  Told sample;
  sample.time = time;
  sample.wrench.force = acting.force + errors_.force_bias + noise_of(noise_, errors_.force_noise);
  sample.wrench.torque =
      acting.torque + errors_.torque_bias + noise_of(noise_, errors_.torque_noise);
  if (fault_ == Fault::Stuck && taken_ > 0)
    sample.wrench = samples_[(taken_ - 1) % kSamples].wrench;
  samples_[taken_ % kSamples] = sample;
  ++taken_;
}

ForceSensor::Told ForceSensor::told(double now) const noexcept {
  const std::uint64_t kept = std::min<std::uint64_t>(taken_, kSamples);
  for (std::uint64_t back = 1; back <= kept; ++back) {
    const Told& sample = samples_[(taken_ - back) % kSamples];
    if (sample.time + delay_ <= now + kSameInstant) return sample;
  }
  return {};
}

}  // namespace rob::drivers
