#pragma once

#include <array>

#include "motion/space/speed_change.h"

namespace rob::motion {

/// Phases of constant jerk from a state to rest. SI.
struct AxisCourse {
  static constexpr int kMostPhases = 7;

  AxisState begin;
  std::array<JerkPhase, kMostPhases> phases{};
  int count = 0;

  void append(const JerkPhase& phase, double duration) noexcept;
  double duration() const noexcept;
  /// t >= 0; after its end it stands there.
  AxisState at(double t) const noexcept;
};

/// One axis from any state to rest at a target, as fast as its limits of speed, acceleration and
/// jerk allow, or in any longer time.
///
///     v   ___________        speed up, go on at v_max, stop: the stop begins as late as
///        /           \       possible
///     __/             \__
///
/// Fastest: the axis makes for v_max (away from the side on which a stop at once would end), which
/// is a speed_change(), and leaves that course for the fastest stop. Where it stops grows with how
/// late it leaves, so the instant is found by Newton's method in a bracket, at most kMostSteps;
/// all else is closed form. The time is the least possible (tests compare it with a search).
/// With infinite jerk it is the same, with leaps of acceleration.
///
/// In a longer time T: a share of the farthest course that ends at T, the rest of the stop at once.
/// Both keep limits that are convex, begin in the same state and are at rest at T; therefore so
/// does every mixture, and one of them ends at the target. So there is one for every T, no blocked
/// intervals, and at rest a copy of the farthest course on a smaller scale.
///
/// Speed or acceleration beyond its limit in the beginning is brought back as speed_change() does,
/// unless the stop begins before. The end is exact. SI. May be used in the tick.
class AxisMotion {
 public:
  /// Newton's method takes 9 in 99 % of all cases; halving a bracket is exact after 60.
  static constexpr int kMostSteps = 100;

  /// Rests at 0.
  AxisMotion() = default;
  AxisMotion(const AxisState& from, double target, const AxisLimits& limits) noexcept;

  /// Takes `time` instead, no less than duration().
  void stretch(double time) noexcept;
  double duration() const noexcept { return duration_; }
  /// t >= 0; from duration() on the rest at the target, exactly.
  AxisState at(double t) const noexcept;

 private:
  AxisLimits limits_;
  double begin_ = 0;
  double way_ = 0;
  double target_ = 0;
  double side_ = 1;  ///< +1 or −1: on which side of the end of stop_ the target lies
  double duration_ = 0;
  AxisCourse stop_;   ///< at once, from 0
  AxisCourse far_;    ///< times side_, from 0
  double share_ = 0;  ///< of far_; the rest is stop_'s
};

}  // namespace rob::motion
