#pragma once

#include "motion/generate/path_record.h"
#include "motion/robots/robot_model.h"
#include "motion/space/axis_motion.h"

namespace rob::motion {

/// Drives axes that stand back on the way that they have come, motion by motion, and forth again:
///
///     began 1     began 2        left
///       o───────────o──────────────o       back(), back(), forth()
///
/// Places of the record pass at half of the rate at which they were recorded at most, and that rate
/// changes so slowly that speed, acceleration and jerk of every axis stay below 0.5, 0.75 and 0.75
/// of their limits where the recorded motion kept them. Every call but the constructor may be used
/// in the tick.
class Retrace {
 public:
  /// `most`: periods of the record; 0: there is never a way back.
  Retrace(const RobotModel& robot, std::size_t most);

  // While the axes go on by themselves:
  void add(const JointVector& q) noexcept { record_.add(q); }
  /// A motion begins; `before`: sooner than with what was added last.
  void mark(Tag tag, bool before) noexcept { record_.mark(tag, before); }
  /// They come to rest for the motion that was marked last.
  void hold_at_mark() noexcept { held_at_ = record_.last_mark(); }
  void go_on() noexcept { held_at_ = -1; }

  /// From rest to where the motion under way began; if that is where they stand, or came to rest
  /// for, the one before. `share`: 0…1 of the rate. False if the record begins here.
  bool back(double share) noexcept;
  /// To where back() left the path.
  void forth(double share) noexcept;
  bool returns() const noexcept { return returns_; }
  /// Comes to rest on the way.
  void halt() noexcept;

  /// The axes are elsewhere than where the path was left.
  bool away() const noexcept { return away_; }
  bool moving() const noexcept { return away_ && time_ < course_.duration(); }
  /// The motion at whose beginning they stand, or will; 0: the record's.
  Tag tag() const noexcept { return tag_; }
  /// So much time passes, s.
  void pass(double time) noexcept;
  /// Where they are now; of `time` the record knows nothing.
  JointReference reference(double time) const noexcept;
  /// The way ends where they stand.
  void stay() noexcept;

 private:
  void aim(double place, double share) noexcept;

  PathRecord record_;
  AxisLimits limits_;    ///< of the place, 1/s, 1/s², 1/s³, at full share
  double held_at_ = -1;  ///< the mark; the axes stand off it by as much as holding takes
  bool away_ = false;
  bool returns_ = false;
  double left_ = 0;  ///< the place
  Tag tag_ = 0;
  AxisMotion course_;  ///< of the place
  double time_ = 0;    ///< since its beginning
};

}  // namespace rob::motion
