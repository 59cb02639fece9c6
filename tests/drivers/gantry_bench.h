#pragma once

#include <vector>

#include "drivers/sim/sim_gantry.h"
#include "motion/servo/following_supervisor.h"
#include "motion/servo/servo_law.h"

namespace rob::test {

inline constexpr double kServoPeriod = 0.005;

/// A gantry's x, y and θ: 12 kg and 0.02 kg·m² with counts of 1 µm and 0.001°. SI.
inline std::vector<motion::DriveData> gantry_drives(double coulomb = 0.3) {
  motion::DriveData linear;
  linear.inertia = 12;
  linear.viscous_friction = 4;
  linear.coulomb_friction = coulomb;
  linear.force_max = 60;
  linear.encoder_resolution = 1e-6;
  linear.bandwidth = 40;
  linear.following_warn = 0.0005;
  linear.following_limit = 0.001;
  motion::DriveData rotary;
  rotary.inertia = 0.02;
  rotary.viscous_friction = 0.01;
  rotary.coulomb_friction = 0.005;
  rotary.force_max = 2;
  rotary.encoder_resolution = 1.7453292519943296e-5;
  rotary.bandwidth = 40;
  rotary.following_warn = 0.01;
  rotary.following_limit = 0.02;
  return {linear, linear, rotary};
}

inline drivers::SimGantryParameters gantry_parameters(double coulomb = 0.3) {
  return {gantry_drives(coulomb), motion::JointVector::Zero(3), {}};
}

/// The servo cycle by hand: read, law, write at equal periods, on any backend.
class GantryBench {
 public:
  GantryBench(motion::ServoBackend& machine, const std::vector<motion::DriveData>& drives)
      : machine_(machine),
        law_(drives, kServoPeriod),
        supervisor_(drives, greatest_speeds(), greatest_accelerations(), kServoPeriod) {
    machine_.open();
    machine_.enable(0);
    machine_.read(0, state_);
    law_.reset(0);
    supervisor_.reset(standing(state_.measured.q), state_.measured);
  }

  static motion::JointVector greatest_speeds() {
    motion::JointVector v(3);
    v << 0.020, 0.020, 0.35;
    return v;
  }
  static motion::JointVector greatest_accelerations() {
    motion::JointVector a(3);
    a << 0.1, 0.1, 1.75;
    return a;
  }
  static motion::JointReference standing(const motion::JointVector& q) {
    return {0, q, motion::JointVector::Zero(3), motion::JointVector::Zero(3)};
  }

  double now() const { return cycle_ * kServoPeriod; }
  const motion::ServoState& state() const { return state_; }
  const motion::ServoCommand& command() const { return command_; }
  motion::ServoLaw& law() { return law_; }

  /// One cycle towards `reference`, which is that of now(); what supervision says of it.
  motion::FollowingFinding cycle(const motion::JointReference& reference) noexcept {
    const double t = now();
    ++cycle_;
    const motion::DriverStatus status = machine_.read(t, state_);
    const motion::FollowingFinding found =
        supervisor_.check(status, reference, reference.q, state_.measured);
    if (status != motion::DriverStatus::Ok) return found;
    command_.reference = reference;
    command_.drive = law_.update(t, reference, state_.measured);
    machine_.write(t, command_);
    return found;
  }

 private:
  motion::ServoBackend& machine_;
  motion::ServoLaw law_;
  motion::FollowingSupervisor supervisor_;
  motion::ServoState state_;
  motion::ServoCommand command_;
  int cycle_ = 0;
};

/// There and back along x, y and θ: pulses of acceleration 21.8 mm/s² (the triangle's peak under
/// S1's law) up to 20 mm/s, 3 s apart; half of it along y, rad for ten mm along θ.
inline motion::JointReference shuttle(double t) {
  constexpr double kA = 0.0218;
  constexpr double kV = 0.020;
  constexpr double kPulse = kV / kA;
  constexpr double kLeg = kPulse + 3;      // start of braking
  constexpr double kTurn = kLeg + kPulse;  // at rest
  constexpr double kLength = kV * kLeg;
  const bool back = t >= kTurn;
  const double u = back ? t - kTurn : t;
  double q = kLength;
  double v = 0;
  double a = 0;
  if (u < kPulse) {
    q = 0.5 * kA * u * u;
    v = kA * u;
    a = kA;
  } else if (u < kLeg) {
    q = 0.5 * kV * kPulse + kV * (u - kPulse);
    v = kV;
  } else if (u < kTurn) {
    q = kLength - 0.5 * kA * (kTurn - u) * (kTurn - u);
    v = kA * (kTurn - u);
    a = -kA;
  }
  motion::JointVector share(3);
  share << 1, 0.5, 10;
  const double sign = back ? -1 : 1;
  return {t, share * (back ? kLength - q : q), share * (sign * v), share * (sign * a)};
}
inline constexpr double kShuttleTime = 2 * (2 * 0.020 / 0.0218 + 3);

}  // namespace rob::test
