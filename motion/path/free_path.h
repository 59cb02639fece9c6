#pragma once

#include "motion/path/follow.h"
#include "motion/path/tool_path.h"
#include "motion/path/value_spline.h"

namespace rob::motion {

/// A path of which the free turn is made as a spline of its parameter says.
class TurnedPath final : public ToolPath {
 public:
  /// The path must outlive it.
  TurnedPath(const ToolPath& path, const FreeTurn& free, ValueSpline angle);

  Pose at(double s) const noexcept override { return turned(path_.at(s), free_, angle_.at(s)); }
  double begin() const noexcept override { return path_.begin(); }
  double end() const noexcept override { return path_.end(); }
  double way() const noexcept override { return path_.way(); }
  double turn() const noexcept override { return turn_; }
  double greatest_speed() const noexcept override { return path_.greatest_speed(); }
  double greatest_turning() const noexcept override { return greatest_turning_; }
  double first_point() const noexcept override { return path_.first_point(); }
  double last_point() const noexcept override { return path_.last_point(); }
  double parts() const noexcept override { return parts_; }
  double at_share(double share) const noexcept override { return path_.at_share(share); }
  double share_at(double s) const noexcept override { return path_.share_at(s); }

 private:
  const ToolPath& path_;
  FreeTurn free_;
  ValueSpline angle_;
  double parts_;
  double turn_ = 0;
  double greatest_turning_ = 0;
};

/// The path with its free turn chosen by a ladder, from `start` on, which brings the tip to its
/// beginning. The free turns of its poses count for nothing; they shall go on from the beginning
/// by the shortest turns (nearest_turn). Where the ladder ends before the path does the turn stays
/// as it is there.
TurnedPath choose_turn(const RobotModel& robot, const ToolPath& path, const Pose& tip,
                       const FreeTurn& free, const JointVector& start);

/// follow(), with the value of a spare axis chosen by a ladder. Paths that are shorter than a rung
/// keep it, where they can. `chosen`: whether it does not keep its value.
Followed follow_choosing(const RobotModel& robot, const ToolPath& path, const Pose& tip,
                         const JointVector& start, bool& chosen);

}  // namespace rob::motion
