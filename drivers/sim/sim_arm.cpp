#include "drivers/sim/sim_arm.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rob::drivers {

using motion::ArmInertia;
using motion::JointVector;

namespace {

// s. Only an arm whose brakes are closed is left alone for so long: it stands long before.
constexpr double kLongestAlone = 0.5;

// Rounds until the friction of axes 2 and 3 agrees. Each leaves H32²/(H22·H33) of the error: with
// 10 kg in the hand about 0.4, 1e-8 in all.
constexpr int kRounds = 20;

constexpr int kAxes = motion::Ums7Dynamics::kAxes;

/// The impulses, each at most `most`, that bring v to rest or as near to it as they can. Axes 2 and
/// 3 alone feel each other.
JointVector friction_impulses(const ArmInertia& h, const JointVector& v, const JointVector& most) {
  JointVector impulse(kAxes);
  const JointVector m = h.diagonal();
  for (const int i : {0, 3, 4, 5}) impulse[i] = std::clamp(-m[i] * v[i], -most[i], most[i]);
  const double det = h.h22 * h.h33 - h.h32 * h.h32;
  const double w22 = h.h33 / det;
  const double w33 = h.h22 / det;
  const double w32 = -h.h32 / det;
  double a = 0;
  double b = 0;
  for (int k = 0; k < kRounds; ++k) {
    a = std::clamp(-(v[1] + w32 * b) / w22, -most[1], most[1]);
    b = std::clamp(-(v[2] + w32 * a) / w33, -most[2], most[2]);
  }
  impulse[1] = a;
  impulse[2] = b;
  return impulse;
}

}  // namespace

SimArm::SimArm(const SimArmParameters& parameters)
    : SimMachine(parameters.start, parameters.actuators),
      bare_(parameters.mechanics),
      carries_what_it_is_told_(parameters.carries_what_it_is_told),
      dynamics_(parameters.mechanics.dynamics),
      load_factor_(kAxes),
      rotor_(kAxes),
      viscous_(kAxes),
      coulomb_(kAxes),
      force_max_(kAxes) {
  if (parameters.drives.size() != kAxes || parameters.start.size() != kAxes)
    throw std::invalid_argument("SimArm: an arm has six drives and six start values");
  for (int i = 0; i < kAxes; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const motion::DriveData& drive = parameters.drives[at];
    const motion::GearedMotor& motor = parameters.mechanics.motors[at];
    load_factor_[i] = motor.load_factor;
    rotor_[i] = motor.inertia / motor.load_factor;
    viscous_[i] = parameters.friction * drive.viscous_friction / motor.load_factor;
    coulomb_[i] = parameters.friction * drive.coulomb_friction / motor.load_factor;
    force_max_[i] = drive.force_max / motor.load_factor;
    encoders_.emplace_back(drive.encoder_resolution);
  }
  SimMachine::open();
}

void SimArm::place(const JointVector& q) noexcept {
  q_ = q;
  v_.setZero(kAxes);
  hold();
  for (int i = 0; i < kAxes; ++i) encoders_[static_cast<std::size_t>(i)].settle(q[i], 0);
}

void SimArm::push(const JointVector& drive) noexcept {
  holding_ = false;
  for (int i = 0; i < kAxes; ++i) {
    const double u = drive[i] / load_factor_[i];
    u_[i] = std::isfinite(u) ? std::clamp(u, -force_max_[i], force_max_[i]) : 0;
  }
}

void SimArm::carry(const motion::CarriedLoad* carried) noexcept {
  if (!carries_what_it_is_told_ || carried == carried_) return;
  carried_ = carried;
  dynamics_ = bare_.carrying(carried == nullptr ? motion::ArmLoad{} : carried->all()).dynamics;
}

void SimArm::hold() noexcept {
  holding_ = true;
  u_.setZero(kAxes);
}

void SimArm::sample() noexcept {
  for (int i = 0; i < kAxes; ++i) encoders_[static_cast<std::size_t>(i)].sample(q_[i]);
}

void SimArm::settle() noexcept {
  for (int i = 0; i < kAxes; ++i) encoders_[static_cast<std::size_t>(i)].settle(q_[i], v_[i]);
}

void SimArm::measure(JointVector& q, JointVector& qd) const noexcept {
  for (int i = 0; i < kAxes; ++i) {
    const Encoder& encoder = encoders_[static_cast<std::size_t>(i)];
    q[i] = encoder.position(q_[i]);
    qd[i] = encoder.velocity();
  }
}

void SimArm::advance(double dt) noexcept {
  const double time = std::min(dt, kLongestAlone);
  const int steps = std::max(1, static_cast<int>(std::ceil(time / Encoder::kPeriod - 1e-6)));
  for (int k = 0; k < steps; ++k) step(time / steps);
}

ArmInertia SimArm::inertia(const JointVector& q) const noexcept {
  ArmInertia h = dynamics_.inertia(q);
  h.add_diagonal(rotor_);
  return h;
}

JointVector SimArm::acceleration(const JointVector& q, const JointVector& v) const noexcept {
  const JointVector torque =
      u_ - viscous_.cwiseProduct(v) - dynamics_.coriolis(q, v) - dynamics_.gravity(q);
  return inertia(q).solve(torque);
}

void SimArm::step(double h) noexcept {
  const JointVector q = q_;
  const JointVector v = v_;
  step_smoothly(h);
  brake(q, v, h);
}

void SimArm::step_smoothly(double h) noexcept {
  const JointVector a1 = acceleration(q_, v_);
  const JointVector v2 = v_ + 0.5 * h * a1;
  const JointVector a2 = acceleration(q_ + 0.5 * h * v_, v2);
  const JointVector v3 = v_ + 0.5 * h * a2;
  const JointVector a3 = acceleration(q_ + 0.5 * h * v2, v3);
  const JointVector v4 = v_ + h * a3;
  const JointVector a4 = acceleration(q_ + h * v3, v4);
  q_ += h / 6 * (v_ + 2 * v2 + 2 * v3 + v4);
  v_ += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

// An axis that its friction holds at the end stands exactly; one that stood before has not moved.
void SimArm::brake(const JointVector& from, const JointVector& v_from, double h) noexcept {
  JointVector most = coulomb_ * h;
  if (holding_) most += force_max_ * h;
  const ArmInertia inertia_here = inertia(q_);
  const JointVector impulse = friction_impulses(inertia_here, v_, most);
  const JointVector change = inertia_here.solve(impulse);
  for (int i = 0; i < kAxes; ++i) {
    const bool held = std::abs(impulse[i]) < most[i];
    const double dv = held ? -v_[i] : change[i];
    q_[i] += 0.5 * h * dv;
    v_[i] += dv;
    if (held && v_from[i] == 0) q_[i] = from[i];
  }
}

}  // namespace rob::drivers
