#pragma once

namespace rob::motion {

/// Slows the path down while the drives cannot follow it. Every force but weight and friction grows
/// with the square of the path's rate, so that drives of which κ times what they have is asked at
/// the rate r suffice at r/√κ. From there the rate recovers, by all of it in kRecovery.
/// Every call may be used in the tick.
class DriveRelief {
 public:
  static constexpr double kRecovery = 0.5;  ///< s
  /// [choice] Where even a tenth is too fast it is not the motion that is too heavy; the following
  /// error stops such a machine.
  static constexpr double kLeast = 0.1;

  explicit DriveRelief(double period) noexcept : step_(period / kRecovery) {}

  /// Once a period. `kappa`: greatest share of what drives have that was demanded; `rate`: of the
  /// path, meanwhile; at rest there is nothing to slow down. Returns share().
  double update(double kappa, double rate) noexcept;
  /// The bound of the path's rate, kLeast … 1.
  double share() const noexcept { return share_; }

 private:
  double step_;
  double share_ = 1;
};

}  // namespace rob::motion
