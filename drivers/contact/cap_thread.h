#pragma once

#include "motion/cell/cell_data.h"

namespace rob::drivers {

/// A cap that is turned on a tube's thread by a hand that is springy about the vertical. SI. The
/// thread is right-handed: turning clockwise as seen from above, positive here, tightens.
///
/// The hand twists until its torque overcomes the thread's friction: running_torque at first, over
/// the last `rise` before the seat growing linearly to slip_torque. At the seat the cap turns no
/// further, and the jaws slip on it at slip_torque.
class CapThread {
 public:
  CapThread(const motion::CapData& cap, double torsion) noexcept : cap_(cap), torsion_(torsion) {}

  /// The torque that turns the cap when `turned` of its thread is on, Nm.
  double friction(double turned) const noexcept;
  /// How much lower it is then than where it begins, m.
  double sink(double turned) const noexcept;

  /// The jaws take hold, without torque.
  void grip() noexcept { twist_ = 0; }
  /// The hand turns by `way`, rad, and the cap on its thread with it: `turned` is renewed, at least
  /// 0.
  void turn(double way, double& turned) noexcept;
  /// The torque of the cap on the hand, about the upward vertical, Nm.
  double torque() const noexcept { return torsion_ * twist_; }

 private:
  motion::CapData cap_;
  double torsion_;
  double twist_ = 0;  // rad by which the hand is ahead of the cap
};

}  // namespace rob::drivers
