#pragma once

#include "motion/generate/drive_relief.h"
#include "motion/robots/robot_model.h"
#include "runtime/tick/tracks.h"

namespace rob::runtime {

/// The share of the programmed speed at which paths are passed: the override, or less while the
/// drives cannot follow. Every call but the constructor may be used in the tick.
class SpeedShare {
 public:
  SpeedShare(const motion::RobotModel& robot, double override_share, Tracks& tracks,
             Channels& channels);

  /// The override, with the program's OVERRIDE.
  void set_override(double share) noexcept;
  /// Once a cycle, which is at `now`, s; `saturation`: as of ServoHistory.
  void relieve_drives(double now, double saturation) noexcept;
  /// The one that holds now.
  double share() const noexcept;

 private:
  Tracks& tracks_;
  Channels& channels_;
  bool scales_time_;   ///< the rate of a sample is that of the path's time
  double most_share_;  ///< of an override that the law can follow
  double override_share_;
  motion::DriveRelief relief_;
  bool reported_ = false;  ///< that the drives have been relieved
};

}  // namespace rob::runtime
