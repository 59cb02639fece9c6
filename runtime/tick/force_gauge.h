#pragma once

#include <array>
#include <cstddef>

#include "motion/robots/robot_model.h"
#include "motion/space/wrench.h"
#include "runtime/tick/channels.h"

namespace rob::runtime {

/// The force that the sensor says, less what it said at the last ZERO force, along the axes of the
/// world. The constructor apart, every call may be used in the tick.
class ForceGauge {
 public:
  /// s that the axes stand for a ZERO force, and of these the last over which its noise is
  /// averaged: what acted while they moved has been reported by then. [choice] 25 servo cycles of
  /// an arm make a fifth of the noise of one; half a second of S4's rest would be lost for nothing.
  static constexpr double kZeroing = 0.1;
  static constexpr double kAveraged = 0.05;

  explicit ForceGauge(const motion::RobotModel& robot) : robot_(robot) {}

  /// The newest report of the servo.
  void take(const ServoSample& sample) noexcept;
  bool feels() const noexcept { return taken_ > 0; }
  /// Somebody counts on it.
  bool zeroed() const noexcept { return zeroed_; }
  /// s for which the sensor has said nothing new: nothing at all, or, where its noise is known, the
  /// same number to the last bit.
  double insensible_for(double now) const noexcept;
  /// Axes at rest: what the sensor says by now is nothing.
  void zero() noexcept;
  /// N, Nm about the flange; `axes`: where they were measured at the same instant.
  motion::Wrench in_world(const motion::JointVector& axes) const noexcept;

 private:
  /// [choice] kAveraged at a servo period of 0.4 ms; shorter ones average less.
  static constexpr std::size_t kKept = 128;

  const motion::RobotModel& robot_;
  std::array<ServoSample::Felt, kKept> kept_{};
  std::size_t taken_ = 0;
  double changed_ = 0;  ///< s: when what it says changed last
  bool zeroed_ = false;
  motion::Wrench zero_;  ///< along the axes of the flange, as kept_
};

}  // namespace rob::runtime
