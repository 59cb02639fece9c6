#pragma once

#include <array>

namespace rob::motion {

/// Where an axis is and how it moves. SI.
struct AxisState {
  double q = 0;
  double v = 0;
  double a = 0;
};

/// The limits of an axis. SI; the jerk may be infinite.
struct AxisLimits {
  double v = 0;
  double a = 0;
  double j = 0;
};

/// A while of constant jerk, and the acceleration at its beginning. SI.
struct JerkPhase {
  double duration = 0;
  double acceleration = 0;
  double jerk = 0;

  /// A state at its beginning, `time` later; the state's own acceleration does not count.
  AxisState after(const AxisState& begin, double time) const noexcept;
};

/// Three phases of a change of speed.
struct SpeedChange {
  std::array<JerkPhase, 3> phases{};

  double duration() const noexcept;
  /// The state at its end.
  AxisState end(AxisState begin) const noexcept;
};

/// From the speed and acceleration of a state to the speed `target` and none, in the least time
/// that the limits of acceleration and jerk allow:
///
///     a     ____           peak² = j·Δv + a²/2, at most a_max;   Δv = target − v
///          /    \          what is missing then is done at a_max
///      a _/      \____     where v + a·|a|/2j > target: the other way up
///
/// An acceleration beyond its limit is brought back at once. With infinite jerk it leaps. May be
/// used in the tick.
SpeedChange speed_change(const AxisState& from, double target, const AxisLimits& limits) noexcept;

}  // namespace rob::motion
