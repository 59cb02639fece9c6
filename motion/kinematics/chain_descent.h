#pragma once

#include "motion/kinematics/joint_chain.h"
#include "motion/kinematics/kinematics.h"

namespace rob::motion {

/// From axis values towards a pose: damped least squares (Levenberg) on the exact Jacobian, where
/// the damping is the error itself (Sugihara 2011), so that it is Newton's method near the end.
/// m, rad; 1 rad counts as 100 mm. Takes no memory; no random numbers and no clock.
class ChainDescent {
 public:
  /// [choice] m or rad: above rounding, far below what any arm repeats.
  static constexpr double kFound = 1e-9;

  explicit ChainDescent(const JointChain& chain) noexcept : chain_(chain) {}

  /// These axes keep their values, one bit each.
  ChainDescent& keep(unsigned axes) noexcept {
    kept_ = axes;
    return *this;
  }
  ChainDescent& leave(Freedom freedom) noexcept {
    free_ = freedom;
    return *this;
  }
  /// After each step axes beyond their limits are put back on them; one that stands on its limit
  /// and would go beyond leaves the step to the others.
  ChainDescent& within_limits() noexcept {
    bounded_ = true;
    return *this;
  }

  /// A start that gets nearer by little is not given up: so it is near singular places.
  ChainDescent& patiently() noexcept {
    patient_ = true;
    return *this;
  }

  /// At most `steps` steps; whether q then brings the flange to `pose`.
  bool run(const Pose& pose, int steps, JointVector& q) const noexcept;
  /// As near to the pose as that many steps bring the flange, reachable or not.
  void approach(const Pose& pose, int steps, JointVector& q) const noexcept;
  /// By how much q misses the pose, counted as run() does, rad.
  double miss(const Pose& pose, const JointVector& q) const noexcept;

 private:
  using Error = Eigen::Matrix<double, 6, 1>;

  Error error(const Pose& pose, const Pose& here) const noexcept;
  using Way = Eigen::Matrix<double, kMaxJoints, 1>;

  bool step(const Error& error, JointChain::Jacobian& jacobian, double damping,
            JointVector& q) const noexcept;
  bool way_to(const Error& error, const JointChain::Jacobian& jacobian, double damping,
              Way& way) const noexcept;
  bool hold_at_limits(const JointVector& q, const Way& way,
                      JointChain::Jacobian& jacobian) const noexcept;
  void take_out_free(const Pose& here, JointChain::Jacobian& jacobian) const noexcept;
  void project(JointVector& q) const noexcept;

  const JointChain& chain_;
  unsigned kept_ = 0;
  Freedom free_ = Freedom::None;
  bool bounded_ = false;
  bool patient_ = false;
};

}  // namespace rob::motion
