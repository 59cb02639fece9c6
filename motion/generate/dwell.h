#pragma once

#include <optional>

#include "motion/generate/position_error.h"
#include "motion/generate/under_way.h"
#include "motion/robots/robot_model.h"

namespace rob::motion {

/// A standstill: for a time of the run, whatever the override, or until the robot is in position.
/// s. Every call may be used in the tick.
class Dwell {
 public:
  Dwell(const RobotModel& robot, const UnderWay& now) noexcept : robot_(robot), now_(now) {}

  void begin(double instant, double duration) noexcept { end_ = instant + duration; }
  /// The reference has come to rest at `instant`. The dwell lasts until the axes are measured
  /// within the segment's SettleWindow, and do not just pass through it.
  void settle(double instant) noexcept;
  /// It stood still for `gap`.
  void skip(double gap) noexcept {
    end_ += gap;
    settle_by_ += gap;
  }
  /// Before the view of a new cycle is taken.
  void keep_measured() noexcept { measured_before_ = now_.view.measured; }

  /// Infinite while it settles.
  double end() const noexcept { return end_; }
  bool settling() const noexcept { return now_.dwelling() && now_.segment.settle.present(); }
  /// s of its time that are over.
  double done() const noexcept;
  /// It settles. None: the robot is in position; else how far off it is.
  std::optional<PositionError> off() const noexcept;
  /// It had to be in position by now.
  bool late() const noexcept;

 private:
  PositionError error(const SettleWindow& window, const JointVector& from) const noexcept {
    return position_error(robot_, window, now_.view.measured, from);
  }

  const RobotModel& robot_;
  const UnderWay& now_;
  double end_ = 0;
  double settle_by_ = 0;
  JointVector measured_before_;  ///< in the cycle before
};

}  // namespace rob::motion
