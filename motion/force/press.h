#pragma once

#include <Eigen/Core>

#include "motion/force/constant_force.h"
#include "motion/robots/robot_model.h"
#include "motion/space/wrench.h"

namespace rob::motion {

/// The data that PRESS asks for. SI.
struct PressOrder {
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< in the world, of length 1
  double force = 0;                                 ///< N: of the reaction along it; not 0
  double limit = 0;                                 ///< m/s along it; 0: kUsualLimit

  static constexpr double kUsualLimit = 5e-3;  ///< [choice] that of S4's program
};

/// A force that is kept along one axis of the world while a path moves the others: the flange is
/// shifted along the axis from where the path leads it.
///
///     path ────────▸        q = inverse(forward(path) + way·axis), its rates by differences
///       way ↓  ╲╱╲_____     way by ConstantForce
///
/// Every call but the constructor may be used in the tick.
class Press {
 public:
  /// m of way after which nothing has been met, or what was pressed on is gone. [choice] beyond the
  /// depth of S4's rack and the stroke of a cap
  static constexpr double kReach = 0.05;

  explicit Press(const RobotModel& robot);

  /// From where it stands, if it is active already.
  void begin(const PressOrder& order) noexcept;
  /// One period on. `braking`: towards standstill, nothing is regulated.
  void step(const Wrench& felt, bool braking) noexcept;
  /// Shifts where the path leads. Where the axes cannot follow, the way ends before (lost()).
  void shift(JointReference& reference) noexcept;
  void end() noexcept { active_ = false; }

  bool active() const noexcept { return active_; }
  /// From where the path leads the flange to where it is, in the world, m.
  Eigen::Vector3d way() const noexcept {
    if (!active_) return Eigen::Vector3d::Zero();
    return base_ + order_.axis * force_.way();
  }
  bool stands() const noexcept { return force_.rate() == 0; }
  bool settled() const noexcept { return force_.settled(); }
  /// It goes no further: the reach of the press, an axis or the arm ends there.
  bool lost() const noexcept { return lost_; }
  /// And it is an axis or the arm.
  bool at_end() const noexcept { return at_end_; }

 private:
  bool shifted(const JointReference& path, double time, double aside, const JointVector& near,
               JointVector& q) const noexcept;
  bool within_limits(const JointVector& path, const JointVector& q) const noexcept;
  bool too_fast(const JointVector& rates, const JointVector& accelerations,
                const JointVector& per_way) const noexcept;
  void end_here() noexcept;

  const RobotModel& robot_;
  ConstantForce force_;
  PressOrder order_;
  Eigen::Vector3d base_ = Eigen::Vector3d::Zero();  ///< m: where way begins, beside the path
  JointVector offset_;  ///< of the last reference from its path, m or rad
  bool active_ = false;
  bool lost_ = false;
  bool at_end_ = false;
};

}  // namespace rob::motion
