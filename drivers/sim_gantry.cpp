#include "drivers/sim_gantry.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace rob::drivers {

using motion::DriverStatus;

namespace {

// After a longer gap only the last part is sampled by the encoders: their estimate has forgotten
// what was before. 50 ms are thirty of its time constants.
constexpr double kSampledGap = 0.05;

void check_channel(int channel) {
  if (channel < 0 || channel > 63) throw std::invalid_argument("SimGantry: channel beyond 0…63");
}

}  // namespace

SimGantry::SimGantry(const SimGantryParameters& parameters) : start_(parameters.start) {
  const auto axes = static_cast<Eigen::Index>(parameters.drives.size());
  if (axes > motion::kMaxJoints || start_.size() != axes)
    throw std::invalid_argument("SimGantry: drives and start position differ in number");
  for (const motion::DriveData& drive : parameters.drives) axes_.emplace_back(drive);
  for (const SimActuatorParameters& actuator : parameters.actuators) {
    check_channel(actuator.output);
    check_channel(actuator.input_off);
    check_channel(actuator.input_on);
    actuators_.emplace_back(actuator);
  }
  power_up();
}

void SimGantry::open() { power_up(); }

void SimGantry::close() noexcept {
  enabled_ = false;
  for (SimAxis& axis : axes_) axis.release();
}

void SimGantry::power_up() noexcept {
  started_ = false;
  enabled_ = false;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    axes_[i].place(start_[static_cast<Eigen::Index>(i)]);
  for (SimActuator& actuator : actuators_) actuator.place_off();
  analog_outputs_ = {};
}

DriverStatus SimGantry::enable(double now) noexcept {
  advance_to(now);
  enabled_ = true;
  written_ = now;
  for (SimAxis& axis : axes_) axis.hold();
  return DriverStatus::Ok;
}

void SimGantry::disable(double now) noexcept {
  advance_to(now);
  enabled_ = false;
  for (SimAxis& axis : axes_) axis.release();
}

DriverStatus SimGantry::read(double now, motion::ServoState& state) noexcept {
  advance_to(now);
  motion::JointMeasurement& measured = state.measured;
  measured.time = now;
  measured.q.resize(start_.size());
  measured.qd.resize(start_.size());
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    measured.q[static_cast<Eigen::Index>(i)] = axes_[i].measured_q();
    measured.qd[static_cast<Eigen::Index>(i)] = axes_[i].measured_v();
  }
  state.inputs = 0;
  for (const SimActuator& actuator : actuators_) state.inputs |= actuator.inputs(now);
  state.analog_inputs = {};  // nothing is wired to them
  return DriverStatus::Ok;
}

DriverStatus SimGantry::write(double now, const motion::ServoCommand& command) noexcept {
  advance_to(now);
  for (SimActuator& actuator : actuators_) actuator.command(now, command.outputs);
  analog_outputs_ = command.analog_outputs;
  if (!enabled_) return DriverStatus::Ok;
  assert(command.drive.size() == start_.size());
  written_ = now;
  for (std::size_t i = 0; i < axes_.size(); ++i)
    axes_[i].push(command.drive[static_cast<Eigen::Index>(i)]);
  return DriverStatus::Ok;
}

double SimGantry::true_position(int axis) const noexcept {
  return axes_[static_cast<std::size_t>(axis)].q();
}

// Without a word from above the drives brake, at the very instant.
void SimGantry::advance_to(double now) noexcept {
  const double alarm = written_ + kWatchdog;
  if (enabled_ && time_ < alarm && alarm <= now) {
    sample_to(alarm);
    for (SimAxis& axis : axes_) axis.hold();
  }
  sample_to(now);
}

void SimGantry::sample_to(double now) noexcept {
  if (!started_ || now - time_ > kSampledGap) skip_to(started_ ? now - kSampledGap : now);
  double next = origin_ + static_cast<double>(samples_ + 1) * Encoder::kPeriod;
  while (next <= now) {
    move_to(next);
    for (SimAxis& axis : axes_) axis.sample();
    ++samples_;
    next = origin_ + static_cast<double>(samples_ + 1) * Encoder::kPeriod;
  }
  move_to(now);
}

// To `now` in one step; the encoders' samples count from there.
void SimGantry::skip_to(double now) noexcept {
  if (started_) move_to(now);
  started_ = true;
  time_ = now;
  origin_ = now;
  samples_ = 0;
  for (SimAxis& axis : axes_) axis.settle();
}

void SimGantry::move_to(double now) noexcept {
  if (now <= time_) return;
  for (SimAxis& axis : axes_) axis.advance(now - time_);
  time_ = now;
}

}  // namespace rob::drivers
