#include "runtime/tick/force_gauge.h"

#include <algorithm>

namespace rob::runtime {

void ForceGauge::take(const ServoSample& sample) noexcept {
  if (sample.felt.time == 0) return;
  const motion::Wrench& before = kept_[(taken_ - 1) % kKept].wrench;
  const motion::Wrench& now = sample.felt.wrench;
  if (taken_ == 0 || now.force != before.force || now.torque != before.torque)
    changed_ = sample.felt.time;
  kept_[taken_++ % kKept] = sample.felt;
}

double ForceGauge::insensible_for(double now) const noexcept {
  if (taken_ == 0) return 0;
  const double told = kept_[(taken_ - 1) % kKept].time + robot_.force.delay;
  return now - (robot_.force.noise > 0 ? std::min(told, changed_ + robot_.force.delay) : told);
}

void ForceGauge::zero() noexcept {
  zeroed_ = true;
  const std::size_t kept = std::min(taken_, kKept);
  motion::Wrench sum;
  std::size_t count = 0;
  for (; count < kept; ++count) {
    const ServoSample::Felt& felt = kept_[(taken_ - 1 - count) % kKept];
    if (felt.time < kept_[(taken_ - 1) % kKept].time - kAveraged) break;
    sum.force += felt.wrench.force;
    sum.torque += felt.wrench.torque;
  }
  if (count == 0) return;
  zero_.force = sum.force / static_cast<double>(count);
  zero_.torque = sum.torque / static_cast<double>(count);
}

motion::Wrench ForceGauge::in_world(const motion::JointVector& axes) const noexcept {
  if (taken_ == 0) return {};
  const motion::Wrench& felt = kept_[(taken_ - 1) % kKept].wrench;
  const Eigen::Quaterniond flange = robot_.kinematics->forward(axes).orientation;
  return {flange * (felt.force - zero_.force), flange * (felt.torque - zero_.torque)};
}

}  // namespace rob::runtime
