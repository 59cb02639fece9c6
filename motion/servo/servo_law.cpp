#include "motion/servo/servo_law.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace rob::motion {
namespace {

constexpr double kPhasePerPeriod = 0.2;  // rad: the most that ω·T may be
constexpr double kIntegralShare = 0.1;   // kI = 0.1·ω·kp
constexpr double kIntegralReach = 0.5;   // of force_max

}  // namespace

double servo_bandwidth(const DriveData& drive, double servo_period) {
  return std::min(drive.bandwidth, kPhasePerPeriod / servo_period);
}

ServoGains servo_gains(double omega, double inertia, double viscous_friction) noexcept {
  ServoGains gains;
  gains.kp = omega * omega * inertia;
  gains.kv = 2 * omega * inertia - viscous_friction;
  gains.ki = kIntegralShare * omega * gains.kp;
  return gains;
}

ServoGains servo_gains(const DriveData& drive, double servo_period) {
  return servo_gains(servo_bandwidth(drive, servo_period), drive.inertia, drive.viscous_friction);
}

ServoLaw::ServoLaw(std::span<const DriveData> drives, double servo_period,
                   const std::optional<ArmMechanics>& arm)
    : feed_forward_(drives, arm), count_(static_cast<int>(drives.size())) {
  assert(drives.size() <= axes_.size());
  for (std::size_t i = 0; i < drives.size(); ++i) {
    axes_[i].drive = drives[i];
    axes_[i].omega = servo_bandwidth(drives[i], servo_period);
  }
}

void ServoLaw::reset(double now) noexcept {
  for (AxisLaw& axis : axes_) axis.e = 0;
  time_ = now;
  saturation_ = 0;
}

void ServoLaw::carry(const ArmLoad& load) noexcept { told_ = load; }

/// At standstill at q.
void ServoLaw::preset_integrals(const JointVector& q) noexcept {
  const JointVector still = JointVector::Zero(count_);
  const JointReference here{time_, q, still, still};
  const JointVector inertia = feed_forward_.at(here).inertia;
  const JointVector weight = feed_forward_.load_weight(q);
  feed_forward_.carry(*told_);
  const JointVector inertia_now = feed_forward_.at(here).inertia;
  const JointVector more = feed_forward_.load_weight(q) - weight;
  for (int i = 0; i < count_; ++i) {
    AxisLaw& axis = axes_[static_cast<std::size_t>(i)];
    const double friction = axis.drive.viscous_friction;
    const double force = axis.e * servo_gains(axis.omega, inertia[i], friction).ki;
    const double learned = force * more[i] > 0
                               ? std::copysign(std::min(std::abs(force), std::abs(more[i])), force)
                               : 0;
    axis.e = (force - learned) / servo_gains(axis.omega, inertia_now[i], friction).ki;
  }
}

JointVector ServoLaw::update(double now, const JointReference& reference,
                             const JointMeasurement& measured) noexcept {
  const double elapsed = std::max(0.0, now - time_);
  time_ = now;
  if (told_) {
    preset_integrals(reference.q);
    told_.reset();
  }
  const MotionForces motion = feed_forward_.at(reference);
  saturation_ = std::max(saturation_, motion.load);
  JointVector u(count_);
  for (int i = 0; i < count_; ++i) {
    AxisLaw& axis = axes_[static_cast<std::size_t>(i)];
    const ServoGains gains =
        servo_gains(axis.omega, motion.inertia[i], axis.drive.viscous_friction);
    u[i] = axis_force(axis, gains, elapsed, feeds_forward_ ? motion.u0[i] : 0,
                      reference.q[i] - measured.q[i], reference.qd[i] - measured.qd[i]);
  }
  return u;
}

double ServoLaw::axis_force(AxisLaw& axis, const ServoGains& gains, double elapsed,
                            double feed_forward, double position_error,
                            double velocity_error) noexcept {
  const auto& [kp, kv, ki] = gains;
  const double u_max = axis.drive.force_max;
  const double reach = kIntegralReach * u_max / ki;
  const double e = std::clamp(axis.e + position_error * elapsed, -reach, reach);
  const double u = feed_forward + kp * position_error + kv * velocity_error + ki * e;
  if (!std::isfinite(u)) return 0;
  saturation_ = std::max(saturation_, std::abs(u) / u_max);
  if (std::abs(u) > u_max) return std::copysign(u_max, u);
  axis.e = e;
  return u;
}

double ServoLaw::take_saturation() noexcept { return std::exchange(saturation_, 0.0); }

}  // namespace rob::motion
