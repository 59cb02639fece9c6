#pragma once

#include <cstddef>

#include "motion/generate/retrace.h"
#include "motion/robots/robot_model.h"
#include "runtime/tick/channels.h"
#include "runtime/tick/speed_share.h"
#include "runtime/tick/tracks.h"

namespace rob::runtime {

/// Drives the axes back on the way that they have come (WayBack), and forth to where they left
/// their path, before the program goes on. Every call but the constructor may be used in the tick.
class Retracing {
 public:
  /// `recorded`: periods of the way of the axes; 0: there is never a way back.
  Retracing(const motion::RobotModel& robot, std::size_t recorded, const SpeedShare& speed,
            Channels& channels);

  /// A further place of the way that the axes go by themselves.
  void record(const motion::JointVector& q) noexcept;
  /// A motion begins; `before`: sooner than with what was recorded last.
  void begin_motion(motion::Tag tag, bool before) noexcept { retrace_.mark(tag, before); }
  /// The axes come to rest for the motion that was begun last.
  void hold_at_motion() noexcept { retrace_.hold_at_mark(); }

  /// `program`: what it does; `barred`: there is no way back now.
  void take_request(const motion::GeneratorSample& program, bool barred, double now) noexcept;
  /// Whether a hold that is `asked` for, or withdrawn, is that of the way back, not that of the
  /// path. `paused`: the path is held.
  bool pause(bool asked, bool paused) noexcept;
  /// The path goes on.
  void go_on() noexcept { retrace_.go_on(); }
  void halt() noexcept;
  /// So much time passes, s. The program's path waits meanwhile; where none is under way the next
  /// one begins where the axes come to stand.
  void follow(Track& program, double time) noexcept;

  /// The axes are elsewhere than where the path was left.
  bool away() const noexcept { return retrace_.away(); }
  bool moving() const noexcept { return retrace_.moving(); }

 private:
  double share() const noexcept;
  void stay(Track& program) noexcept;

  const SpeedShare& speed_;
  Channels& channels_;
  motion::Retrace retrace_;
};

}  // namespace rob::runtime
