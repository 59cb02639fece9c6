#include "motion/path/paul_transition.h"

namespace rob::motion {

PaulTransition::PaulTransition(const JointVector& a, const JointVector& b, const JointVector& c,
                               double t1, double t_acc) noexcept
    : b_(b),
      delta_b_(a - b),
      velocity_((c - b) / t1),
      turn_((c - b) * (t_acc / t1) + (a - b)),
      t_acc_(t_acc) {}

PathPoint PaulTransition::sample(double t) const noexcept {
  if (t < t_acc_) return corner((t + t_acc_) / (2 * t_acc_));
  return {b_ + velocity_ * t, velocity_, JointVector::Zero(b_.size())};
}

// S1, the transition's polynomial and its derivatives, 0 <= h <= 1.
PathPoint PaulTransition::corner(double h) const noexcept {
  const double t_acc = t_acc_;
  return {(turn_ * ((2 - h) * h * h) - 2 * delta_b_) * h + b_ + delta_b_,
          (turn_ * ((1.5 - h) * 2 * h * h) - delta_b_) / t_acc,
          turn_ * ((1 - h) * 3 * h / (t_acc * t_acc))};
}

}  // namespace rob::motion
