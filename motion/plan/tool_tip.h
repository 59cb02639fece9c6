#pragma once

#include <Eigen/Core>

#include "motion/plan/leg_demand.h"
#include "motion/robots/robot_model.h"
#include "motion/space/pose.h"

namespace rob::motion {

/// The tip of the tool that a robot carries, at first its flange, and how motions that are straight
/// in the axes move it. m, rad, s.
class ToolTip {
 public:
  explicit ToolTip(const RobotModel& robot) noexcept;

  void set(const Pose& tip) noexcept;
  /// Seen from the flange.
  const Pose& pose() const noexcept { return tip_; }
  /// In the world.
  Pose pose_at(const JointVector& q) const noexcept {
    return composed(robot_.kinematics->forward(q), tip_);
  }
  Eigen::Vector3d place_at(const JointVector& q) const noexcept {
    return place_of(tip_.position, robot_.kinematics->forward(q));
  }
  /// The greatest that the axes can give it.
  double greatest_speed() const noexcept { return greatest_speed_; }
  /// Whether a rotary axis moves it.
  bool swings() const noexcept { return !arms_.isZero(); }

  double distance(const JointVector& from, const JointVector& to) const noexcept {
    return (place_at(to) - place_at(from)).norm();
  }
  /// How far it can swing beside the straight line: what the rotary axes turn, times how far it can
  /// be from them.
  double swing(const JointVector& from, const JointVector& to) const noexcept {
    return arms_.dot((to - from).cwiseAbs());
  }
  LegDemand demand(const JointVector& from, const JointVector& to) const noexcept;
  /// Where it swings beside its straight way: how far it goes, and its greatest speed.
  void measure_swing(const JointVector& from, const JointVector& to, LegDemand& demand) const;

 private:
  double greatest_way(const JointVector& from, const JointVector& to) const noexcept;
  double leaving_speed(const JointVector& from, const JointVector& to) const noexcept;

  const RobotModel& robot_;
  Pose tip_;
  JointVector arms_;  ///< how far it can be from the rotary axes; 0 of linear ones
  double greatest_speed_ = 0;
};

}  // namespace rob::motion
