#include "drivers/sim/sim_gantry.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rob::drivers {

using motion::JointVector;

namespace {

// s. Pulses never last longer than a servo period, and without them the axes stand before long.
constexpr double kLongest = 0.5;

}  // namespace

SimGantry::SimGantry(const SimGantryParameters& parameters)
    : SimMachine(parameters.start, parameters.actuators), pulse_drives_(parameters.pulse_drives) {
  const auto count = static_cast<Eigen::Index>(parameters.drives.size());
  if (count > motion::kMaxJoints || parameters.start.size() != count)
    throw std::invalid_argument("SimGantry: drives and start position differ in number");
  if (!pulse_drives_.empty() && pulse_drives_.size() != parameters.drives.size())
    throw std::invalid_argument("SimGantry: drives and pulse drives differ in number");
  for (const motion::DriveData& drive : parameters.drives) axes_.emplace_back(drive);
  SimMachine::open();
}

void SimGantry::place(const JointVector& q) noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i) axes_[i].place(q[static_cast<Eigen::Index>(i)]);
  follows_pulses_ = false;
}

void SimGantry::push(const JointVector& drive) noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const double command = drive[static_cast<Eigen::Index>(i)];
    if (pulse_drives_.empty()) {
      axes_[i].push(command);
      continue;
    }
    if (!follows_pulses_) pulse_drives_[i].clear(axes_[i].measured_q());
    pulse_drives_[i].take(command);
  }
  follows_pulses_ = !pulse_drives_.empty();
}

void SimGantry::hold() noexcept {
  for (SimAxis& axis : axes_) axis.hold();
  follows_pulses_ = false;
}

void SimGantry::release() noexcept {
  for (SimAxis& axis : axes_) axis.release();
  follows_pulses_ = false;
}

void SimGantry::advance(double dt) noexcept {
  if (follows_pulses_) return follow_pulses(std::min(dt, kLongest));
  for (SimAxis& axis : axes_) axis.advance(dt);
}

void SimGantry::follow_pulses(double dt) noexcept {
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / Encoder::kPeriod - 1e-6)));
  const double h = dt / steps;
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    SimAxis& axis = axes_[i];
    for (int k = 0; k < steps; ++k) {
      axis.push(pulse_drives_[i].force(h, axis.q(), axis.measured_q(), axis.v()));
      axis.advance(h);
    }
  }
}

void SimGantry::sample() noexcept {
  for (SimAxis& axis : axes_) axis.sample();
}

void SimGantry::advance_sampled(std::int64_t count) noexcept {
  if (follows_pulses_) return SimMachine::advance_sampled(count);
  for (SimAxis& axis : axes_) axis.advance_sampled(count);
}

void SimGantry::settle() noexcept {
  for (SimAxis& axis : axes_) axis.settle();
}

void SimGantry::measure(JointVector& q, JointVector& qd) const noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    q[static_cast<Eigen::Index>(i)] = axes_[i].measured_q();
    qd[static_cast<Eigen::Index>(i)] = axes_[i].measured_v();
  }
}

}  // namespace rob::drivers
