#pragma once

#include <algorithm>

#include "motion/generate/stop_ramp.h"

namespace rob::motion {

/// Turns the run's time into the path's: path time = stamp − lag.
///
/// The lag is exactly 0 until something has slowed the motion, and does not change while the time
/// scale is 1, so that a run without hold or override has the same bits however late its ticks
/// came. hold(), resume() and set_override() scale time along the same curve (StopRamp). A change
/// that slows takes effect at once, one that quickens from the next stamp on, so that nothing is
/// reached earlier than next() has announced.
///
/// s. Every call may be used in the tick.
class PathClock {
 public:
  PathClock(const TimeScaleLimits& limits, double period) noexcept;

  void hold() noexcept { holding_ = true; }
  void resume() noexcept { holding_ = false; }
  /// 0 < share <= 1; what is above counts as 1, what is no positive number changes nothing.
  void set_override(double share) noexcept;

  /// The axes stand: what set_override() asks for holds from this stamp on.
  void jump() noexcept { ramp_.jump(goal()); }

  /// Whether the time scale does not change.
  bool steady() const noexcept { return ramp_.remaining() == 0; }
  /// Only while steady: how fast it may change from now on.
  void set_limits(const TimeScaleLimits& limits) noexcept { ramp_.set_limits(limits); }

  /// Goes on to `stamp`. With the axes `at_rest` the time scale may change at once.
  void advance(double stamp, bool at_rest) noexcept;
  /// The path has stood still for `gap`.
  void skip(double gap) noexcept;

  double stamp() const noexcept { return stamp_; }
  double path_time() const noexcept { return path_; }
  double rate() const noexcept { return ramp_.rate(); }
  double slope() const noexcept { return ramp_.slope(); }
  double override_share() const noexcept { return override_; }
  /// Holding, and come to rest.
  bool held() const noexcept { return holding_ && ramp_.rate() == 0 && steady(); }
  /// When, within the last advance(), the time scale became steady.
  double steady_since() const noexcept;
  /// The path time that one more period will reach if nothing is asked for.
  double next() const noexcept;
  /// The run's time at a path time that the last advance() passed, and the other way round.
  double run_time(double path_time) const noexcept;
  double path_time_at(double run_time) const noexcept;
  /// Path time at an instant of the last period; before or after it that of its ends.
  double passed_by(double run_time) const noexcept {
    return run_time >= stamp_ ? path_ : path_time_at(std::max(run_time, stamp_before_));
  }

 private:
  double goal() const noexcept { return holding_ ? 0 : override_; }
  static bool as_planned(const StopRamp& ramp) noexcept;

  double period_;
  StopRamp ramp_;
  StopRamp ramp_before_;  ///< at the stamp before
  double stamp_;
  double stamp_before_;
  double path_;
  double path_before_;
  double lag_ = 0;
  double override_ = 1;
  bool holding_ = false;
};

}  // namespace rob::motion
