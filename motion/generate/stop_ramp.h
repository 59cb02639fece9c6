#pragma once

#include "motion/robots/time_scaling.h"
#include "motion/space/speed_change.h"

namespace rob::motion {

/// The time scale r of a motion: 1 as planned, 0 at rest on the path. From whatever r and r' it
/// has, it goes to the aim in the least time with |r'| and |r''| bounded, so that the axes'
/// accelerations and jerks stay bounded wherever on the path that is (time_scaling.h).
///
///     r'   ____
///         /    \        three phases of constant r'': towards the aim, cruise, level off;
///     ___/      \___    the first may have to turn r' round
///
/// 1, s. Every call may be used in the tick.
class StopRamp {
 public:
  /// r = 1, steady.
  explicit StopRamp(const TimeScaleLimits& limits) noexcept : limits_(limits) {}

  /// From the next aim on. Only while steady.
  void set_limits(const TimeScaleLimits& limits) noexcept { limits_ = limits; }
  /// Goes to `target`, 0 <= target <= 1, from the current r and r'.
  void aim(double target) noexcept;
  /// Is there at once. Only for axes at rest.
  void jump(double target) noexcept;

  /// Goes on by dt; returns the path time gained, ∫ r dt.
  double advance(double dt) noexcept;
  /// The dt in 0 … within after which `gain` has been gained.
  double time_to_gain(double gain, double within) const noexcept;

  double rate() const noexcept { return rate_; }
  double slope() const noexcept { return slope_; }
  double target() const noexcept { return target_; }
  /// s until the aim is reached; 0: steady.
  double remaining() const noexcept { return ahead_.duration(); }

 private:
  TimeScaleLimits limits_;
  double rate_ = 1;
  double slope_ = 0;
  double target_ = 1;
  SpeedChange ahead_;  ///< what is still to come
};

}  // namespace rob::motion
