#include "drivers/sim/sim_machine.h"

#include <cassert>
#include <stdexcept>

#include "drivers/sim/encoder.h"

namespace rob::drivers {

using motion::DriverStatus;

namespace {

// After a longer gap only the last part is sampled by the encoders: their estimate has forgotten
// what was before. 50 ms are thirty of its time constants.
constexpr double kSampledGap = 0.05;

// A share of a period. Instants that differ by less are the same but for rounding: the next step
// goes through so short a time.
constexpr double kSameSample = 1e-9;

void check_channel(int channel) {
  if (channel < 0 || channel > 63) throw std::invalid_argument("SimMachine: channel beyond 0…63");
}

}  // namespace

SimMachine::SimMachine(const motion::JointVector& start,
                       const std::vector<SimActuatorParameters>& actuators)
    : start_(start) {
  for (const SimActuatorParameters& actuator : actuators) {
    check_channel(actuator.output);
    check_channel(actuator.input_off);
    check_channel(actuator.input_on);
    actuators_.emplace_back(actuator);
  }
}

void SimMachine::open() {
  started_ = false;
  enabled_ = false;
  place(start_);
  for (SimActuator& actuator : actuators_) actuator.place_off();
  analog_outputs_ = {};
}

void SimMachine::close() noexcept {
  enabled_ = false;
  release();
}

DriverStatus SimMachine::enable(double now) noexcept {
  advance_to(now);
  enabled_ = true;
  written_ = now;
  hold();
  return DriverStatus::Ok;
}

void SimMachine::disable(double now) noexcept {
  advance_to(now);
  enabled_ = false;
  release();
}

DriverStatus SimMachine::read(double now, motion::ServoState& state) noexcept {
  advance_to(now);
  motion::JointMeasurement& measured = state.measured;
  measured.time = now;
  measured.q.resize(start_.size());
  measured.qd.resize(start_.size());
  measure(measured.q, measured.qd);
  state.inputs = 0;
  for (const SimActuator& actuator : actuators_) state.inputs |= actuator.inputs(now);
  state.analog_inputs = {};  // nothing is wired to them
  return DriverStatus::Ok;
}

DriverStatus SimMachine::write(double now, const motion::ServoCommand& command) noexcept {
  advance_to(now);
  for (SimActuator& actuator : actuators_) actuator.command(now, command.outputs);
  analog_outputs_ = command.analog_outputs;
  if (!enabled_) return DriverStatus::Ok;
  assert(command.drive.size() == start_.size());
  written_ = now;
  carry(command.carried);
  push(command.drive);
  return DriverStatus::Ok;
}

// Without a word from above the drives brake, at the very instant.
void SimMachine::advance_to(double now) noexcept {
  const double alarm = written_ + kWatchdog;
  if (enabled_ && time_ < alarm && alarm <= now) {
    sample_to(alarm);
    hold();
  }
  sample_to(now);
}

void SimMachine::sample_to(double now) noexcept {
  if (!started_ || now - time_ > kSampledGap) skip_to(started_ ? now - kSampledGap : now);
  const auto due = static_cast<std::int64_t>((now - origin_) / Encoder::kPeriod + kSameSample);
  if (due > samples_ && time_ > sample_instant(samples_)) {  // the period that has begun
    move_to(sample_instant(++samples_));
    sample();
  }
  if (due > samples_) {
    advance_sampled(due - samples_);
    samples_ = due;
    time_ = sample_instant(due);
  }
  move_to(now);
}

void SimMachine::advance_sampled(std::int64_t count) noexcept {
  for (std::int64_t i = 0; i < count; ++i) {
    advance(Encoder::kPeriod);
    sample();
  }
}

double SimMachine::sample_instant(std::int64_t number) const noexcept {
  return origin_ + static_cast<double>(number) * Encoder::kPeriod;
}

// To `now` in one step; the encoders' samples count from there.
void SimMachine::skip_to(double now) noexcept {
  if (started_) move_to(now);
  started_ = true;
  time_ = now;
  origin_ = now;
  samples_ = 0;
  settle();
}

void SimMachine::move_to(double now) noexcept {
  if (now - time_ <= kSameSample * Encoder::kPeriod) return;
  advance(now - time_);
  time_ = now;
}

}  // namespace rob::drivers
