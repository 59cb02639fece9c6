#include "motion/force/press.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {

namespace {

/// N/m where the robot file says nothing. [choice] the stiffest of S4's cells, 150 N/mm
constexpr double kStiffest = 150e3;

/// m/s² along the axis. [choice] an arm of 0.4 m takes 70 deg/s² of its axes for it; half of what a
/// linear axis has
constexpr double kPressAcceleration = 0.5;
/// m/s³, the same. [choice] 2900 deg/s³ of such axes; S4's 5 mm/s are taken back in 32 ms
constexpr double kJerk = 20;

/// s between the inverse solutions whose differences are speed and acceleration (VelocityMode).
constexpr double kInstant = 0x1p-11;

PressContact contact_of(const RobotModel& robot) {
  PressContact contact{robot.force.stiffness > 0 ? robot.force.stiffness : kStiffest,
                       robot.force.delay, robot.reference_period, kPressAcceleration, kJerk};
  for (const Axis& axis : robot.axes) {
    if (axis.kind != AxisKind::Linear) continue;
    contact.acceleration = std::min(contact.acceleration, axis.a_max / 2);
    contact.jerk = std::min(contact.jerk, axis.j_max / 2);
  }
  return contact;
}

}  // namespace

Press::Press(const RobotModel& robot)
    : robot_(robot), force_(contact_of(robot)), offset_(JointVector::Zero(robot.axis_count())) {}

void Press::begin(const PressOrder& order) noexcept {
  if (active_) {
    base_ += order_.axis * force_.way();
  } else {
    base_.setZero();
    offset_.setZero();
  }
  order_ = order;
  force_.begin(order.force, order.limit > 0 ? order.limit : PressOrder::kUsualLimit);
  active_ = true;
  lost_ = at_end_ = false;
}

void Press::step(const Wrench& felt, bool braking) noexcept {
  if (!lost_ && std::abs(force_.way()) > kReach) lost_ = true;
  braking || lost_ ? force_.brake() : force_.step(felt.force.dot(order_.axis));
}

void Press::shift(JointReference& reference) noexcept {
  const JointReference path = reference;
  constexpr double kAside = 1e-6;  // m
  JointVector before;
  JointVector after;
  JointVector aside;
  const bool possible = shifted(path, 0, 0, path.q + offset_, reference.q) &&
                        shifted(path, -kInstant, 0, reference.q, before) &&
                        shifted(path, kInstant, 0, reference.q, after) &&
                        shifted(path, 0, kAside, reference.q, aside);
  if (!possible) {  // it stays beside the path as it was
    end_here();
    reference = path;
    reference.q += offset_;
    return;
  }
  const JointVector rates = (after - before) / (2 * kInstant);
  const PressContact& contact = force_.contact();
  const double stops_in = std::abs(force_.rate()) / (2 * contact.acceleration) +
                          std::sqrt(std::abs(force_.rate()) / contact.jerk) + contact.period;
  const JointVector added = rates - path.qd;
  const JointVector bends = (after - reference.q * 2 + before) / (kInstant * kInstant);
  const bool within = within_limits(path.q, reference.q + added * stops_in);
  if (!within || too_fast(added, bends - path.qdd, (aside - reference.q) / kAside)) end_here();
  offset_ = reference.q - path.q;
  if (stands() && path.qd.isZero(0)) return;
  reference.qd = rates;
  reference.qdd = bends;
}

/// Whether an axis must be faster than it can; or, where the arm is stretched or its wrist is
/// singular and a way of next to nothing takes axes far, soon must be: their speeds change though
/// the way's does not. `per_way`: rad/m of the way that the force leads.
bool Press::too_fast(const JointVector& rates, const JointVector& accelerations,
                     const JointVector& per_way) const noexcept {
  constexpr double kMost = 1.0 / 4;  // of a_max. [choice] the rest is to brake with
  constexpr double kCreeps = 1e-6;   // m/s: below, nothing is gone in time
  if (std::abs(force_.rate()) < kCreeps) return false;
  const JointVector turns = accelerations - per_way * force_.acceleration();
  for (int i = 0; i < rates.size(); ++i) {
    const Axis& axis = robot_.axes[static_cast<std::size_t>(i)];
    if (std::abs(rates[i]) > axis.v_max || std::abs(turns[i]) > kMost * axis.a_max) return true;
  }
  return false;
}

void Press::end_here() noexcept {
  at_end_ = at_end_ || !lost_;
  lost_ = true;
}

/// The axes `time` later and so far aside; false where the arm does not reach.
bool Press::shifted(const JointReference& path, double time, double aside, const JointVector& near,
                    JointVector& q) const noexcept {
  const double half = time * time / 2;
  Pose flange = robot_.kinematics->forward(path.q + path.qd * time + path.qdd * half);
  flange.position += base_ + order_.axis * (force_.way() + aside + force_.rate() * time +
                                            force_.acceleration() * half);
  const auto found = robot_.kinematics->inverse(flange, near);
  if (found) q = *found;
  return found.has_value();
}

/// Whether no axis is brought beyond its end.
bool Press::within_limits(const JointVector& path, const JointVector& q) const noexcept {
  for (int i = 0; i < q.size(); ++i) {
    const Axis& axis = robot_.axes[static_cast<std::size_t>(i)];
    if (q[i] < path[i] && q[i] < axis.min) return false;
    if (q[i] > path[i] && q[i] > axis.max) return false;
  }
  return true;
}

}  // namespace rob::motion
