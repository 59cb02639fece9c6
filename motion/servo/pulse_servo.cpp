#include "motion/servo/pulse_servo.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace rob::motion {
namespace {

constexpr double kInnerPhase = 0.4;          // rad: the most that ω_v·T may be
constexpr double kOuterShare = 0.25;         // kp/ω_v
constexpr double kPulseIntegralShare = 0.5;  // ki/((1 + kv)·kp)

}  // namespace

PulseGains pulse_gains(const DriveData& drive, const PulseDriveData& pulses,
                       ServoStructure structure, double servo_period) {
  const double D = pulses.speed_stiffness;
  const double Dc = drive.viscous_friction;
  PulseGains gains;
  if (structure != ServoStructure::DoubleLoop) {
    const double tau = drive.inertia / (D + Dc);
    gains.kp = (1 + Dc / D) / (4 * tau);
    return gains;
  }
  const double omega = std::min(drive.bandwidth / kOuterShare, kInnerPhase / servo_period);
  gains.kp = kOuterShare * omega;
  gains.kv = std::max(0.0, (omega * drive.inertia - Dc) / D - 1);
  gains.ki = kPulseIntegralShare * (1 + gains.kv) * gains.kp;
  return gains;
}

PulseServo::PulseServo(std::span<const DriveData> drives, std::span<const PulseDriveData> pulses,
                       ServoStructure structure, double servo_period)
    : count_(static_cast<int>(drives.size())), structure_(structure), period_(servo_period) {
  assert(drives.size() <= axes_.size() && drives.size() == pulses.size());
  assert(structure != ServoStructure::Force);
  for (std::size_t i = 0; i < drives.size(); ++i) {
    AxisLoop& axis = axes_[i];
    axis.gains = pulse_gains(drives[i], pulses[i], structure, servo_period);
    axis.pulse = pulses[i].pulse;
    axis.reach = drives[i].force_max / pulses[i].speed_stiffness;
    axis.feed = 1 + drives[i].viscous_friction / pulses[i].speed_stiffness;
  }
}

void PulseServo::reset(double now) noexcept {
  for (AxisLoop& axis : axes_) axis.integral = axis.rest = 0;
  time_ = now;
  begun_ = false;
  saturation_ = 0;
}

JointVector PulseServo::update(double now, const JointReference& reference,
                               const JointMeasurement& measured) noexcept {
  const double elapsed = std::max(0.0, now - time_);
  time_ = now;
  JointVector pulses(count_);
  for (int i = 0; i < count_; ++i) {
    AxisLoop& axis = axes_[static_cast<std::size_t>(i)];
    if (!begun_) axis.sent = measured.q[i];
    const double at = structure_ == ServoStructure::PulseTrain ? axis.sent : measured.q[i];
    const double v = rate(axis, elapsed, reference.q[i] - at, reference.qd[i], measured.qd[i]);
    pulses[i] = std::isfinite(v) ? whole_pulses(axis, v * period_) : 0;
  }
  begun_ = true;
  return pulses;
}

double PulseServo::rate(AxisLoop& axis, double elapsed, double position_error,
                        double reference_rate, double measured_rate) noexcept {
  const auto& [kp, kv, ki] = axis.gains;
  if (structure_ == ServoStructure::PulseTrain) return reference_rate + position_error / period_;
  double v = reference_rate * axis.feed + kp * position_error;
  double integral = axis.integral;
  if (structure_ == ServoStructure::DoubleLoop) {
    const double wanted = reference_rate + kp * position_error;
    integral += (wanted - measured_rate) * elapsed;
    v = wanted + kv * (wanted - measured_rate) + ki * integral;
  }
  if (!std::isfinite(v)) return v;
  const double demand = std::abs(v - measured_rate) / axis.reach;
  saturation_ = std::max(saturation_, demand);
  if (demand > 1) return measured_rate + std::copysign(axis.reach, v - measured_rate);
  axis.integral = integral;
  return v;
}

double PulseServo::whole_pulses(AxisLoop& axis, double way) noexcept {
  const double wanted = way / axis.pulse + axis.rest;
  const double whole = std::nearbyint(wanted);
  axis.rest = wanted - whole;
  axis.sent += way;
  return whole;
}

double PulseServo::take_saturation() noexcept { return std::exchange(saturation_, 0.0); }

}  // namespace rob::motion
