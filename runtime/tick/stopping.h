#pragma once

#include "motion/robots/robot_model.h"
#include "motion/servo/following_supervisor.h"
#include "runtime/tick/channels.h"
#include "runtime/tick/effects.h"
#include "runtime/tick/last_stop.h"
#include "runtime/tick/retracing.h"
#include "runtime/tick/tracks.h"

namespace rob::runtime {

/// How the axes come to rest before what was commanded is done: paused on their path, until that is
/// withdrawn; held there for good, where the outputs take their SAFE values at once; or off it, by
/// LastStop. Every call but the constructor may be used in the tick; `now`: of the current cycle,
/// s.
class Stopping {
 public:
  Stopping(const motion::RobotModel& robot, Tracks& tracks, Retracing& retracing, Effects& effects,
           Channels& channels);

  void take(const ServoSample& sample, double now) noexcept;
  /// `time`: when it was found, s. One of each verdict is reported; the stop counts alone.
  void take_finding(double time, const motion::FollowingFinding& finding, double now) noexcept;
  /// Motion itself has found that it cannot go on.
  void fail(double now) noexcept;
  /// The axes were left to themselves for too long.
  void lose_touch(double now) noexcept { last_stop_.lose_touch(now); }

  /// A fault, and a hold for good, take precedence.
  void pause(bool asked) noexcept;
  void hold(double now) noexcept;
  /// From the reference that was handed out last; then without force.
  void brake(double now) noexcept;
  /// While the axes are off their path, the reference of `stamp` in place of the generator's.
  void lead(double stamp) noexcept;

  bool faulted() const noexcept { return faulted_; }
  bool for_good() const noexcept { return for_good_; }
  /// The axes stand, or will.
  bool held() const noexcept { return paused_ || for_good_; }
  /// They will go on.
  bool pausing() const noexcept { return paused_ && !for_good_; }
  bool off_path() const noexcept { return last_stop_.active(); }

 private:
  Tracks& tracks_;
  Retracing& retracing_;
  Effects& effects_;
  Channels& channels_;
  LastStop last_stop_;
  bool warned_ = false;
  bool faulted_ = false;
  bool paused_ = false;
  bool for_good_ = false;
  bool disables_ = false;  ///< the drives, when the last stop has come to its end
};

}  // namespace rob::runtime
