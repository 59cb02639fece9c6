#include "drivers/sim/pulse_drive.h"

#include <algorithm>
#include <cmath>

#include "base/unit_factors.h"

namespace rob::drivers {

PulseDrive::PulseDrive(const motion::PulseDriveData& data, double servo_period, double gain)
    : data_(data), period_(servo_period), gain_(gain) {}

void PulseDrive::clear(double q) noexcept {
  left_ = 0;
  rate_ = 0;
  way_ = q;
}

void PulseDrive::take(double pulses) noexcept {
  const double way = std::isfinite(pulses) ? pulses * data_.pulse : 0;
  rate_ = (rate_ * left_ + way) / period_;
  left_ = period_;
}

double PulseDrive::force(double h, double q, double counted, double v) noexcept {
  const double way = rate_ * std::min(h, left_);
  left_ = std::max(0.0, left_ - h);
  way_ += way;
  const double wanted = gain_ > 0 ? gain_ * (way_ - counted) : way / h;
  const double wave = std::sin(kFullTurn * q / data_.ripple_period);
  return data_.speed_stiffness * (wanted - v) + data_.ripple * wave;
}

}  // namespace rob::drivers
