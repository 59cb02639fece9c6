#include "runtime/run/peak_meter.h"

#include <algorithm>
#include <cmath>

#include "runtime/words/units.h"

namespace rob::runtime {

PeakMeter::PeakMeter(const motion::RobotModel& robot) {
  for (const motion::Axis& axis : robot.axes) {
    axes_.push_back({shown_per_si(axis.kind)});
    peaks_.push_back({axis.name});
  }
}

/// A speed is that of the middle of its period, an acceleration that of the middle between two.
void PeakMeter::take(const motion::JointReference& reference) {
  const double period = reference.time - time_;
  if (taken_ > 0 && !(period > 0)) return;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    Axis& axis = axes_[i];
    AxisPeak& peak = peaks_[i];
    const double q = axis.scale * reference.q[static_cast<Eigen::Index>(i)];
    const double v = taken_ > 0 ? (q - axis.q) / period : 0;
    const double a = taken_ > 1 ? (v - axis.v) / ((period + last_period_) / 2) : 0;
    const double between = (period + 2 * last_period_ + former_period_) / 4;
    const double j = taken_ > 2 ? (a - axis.a) / between : 0;
    peak.v = std::max(peak.v, std::abs(v));
    peak.a = std::max(peak.a, std::abs(a));
    peak.j = std::max(peak.j, std::abs(j));
    axis = {axis.scale, q, v, a};
  }
  former_period_ = last_period_;
  last_period_ = period;
  time_ = reference.time;
  taken_ = std::min(taken_ + 1, 3);
}

}  // namespace rob::runtime
