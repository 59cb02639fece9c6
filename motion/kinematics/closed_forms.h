#pragma once

#include <optional>

#include "motion/kinematics/arm_kinematics.h"
#include "motion/kinematics/joint_chain.h"

namespace rob::motion {

/// How far a chain may be from a structure that has a closed form: lines that should meet, m, and
/// directions, rad.
struct StructureTolerance {
  static constexpr double kDistance = 1e-3;
  static constexpr double kAngle = 1e-3;
};

/// A chain of six rotary axes whose last three meet in one point, on axes as an ArmKinematics has
/// them. Its solutions are those of the nominal arm, which is within the tolerance of the chain.
class WristForm {
 public:
  static std::optional<WristForm> of(const JointChain& chain);

  InverseSolutions solutions(const Pose& pose, const JointVector& near) const noexcept;

 private:
  WristForm(const ArmParameters& arm, const Pose& base, const Pose& flange)
      : arm_(arm), base_(base), flange_(flange) {}

  ArmKinematics arm_;
  Pose base_;    ///< the arm's base, seen from the chain's
  Pose flange_;  ///< seen from the arm's flange
};

/// A chain of six rotary axes of which 2, 3 and 4 are parallel, across axis 1, and 5 and 6 meet at
/// a right angle, as on Universal Robots' arms. The nominal arm's solutions, as above.
class ParallelForm {
 public:
  static std::optional<ParallelForm> of(const JointChain& chain);

  InverseSolutions solutions(const Pose& pose, const JointVector& near) const noexcept;

 private:
  ParallelForm() = default;

  struct Turned;
  void turn(const Eigen::Matrix3d& hand, const Eigen::Vector3d& wrist, double theta1,
            const JointVector& near, InverseSolutions& found) const noexcept;
  void bend(const Turned& turned, const JointVector& near, InverseSolutions& found) const noexcept;

  // Seen from the base below, all angles at zero: x ahead, y along axis 2, z up.
  Pose base_;              ///< on axis 1 at the height of axis 2, seen from the chain's base
  Pose flange_;            ///< seen from where axes 5 and 6 meet: z along axis 6, y along axis 5
  double a1_ = 0;          ///< axis 2 ahead of axis 1
  double b_ = 0;           ///< where axes 5 and 6 meet, along y
  double upper_ = 0;       ///< m from axis 2 to 3
  double fore_ = 0;        ///< and from 3 to 4
  double upper_lean_ = 0;  ///< rad from z towards x
  double fore_lean_ = 0;   ///< likewise
  double hand_lean_ = 0;   ///< likewise of axis 5
  double tilt_ = 0;        ///< of axis 6 from y, about axis 5
  double sign3_ = 1;       ///< of axes 3 and 4 about y
  double sign4_ = 1;
  Eigen::Vector2d offset_{0, 0};  ///< from axis 4 to where axes 5 and 6 meet: x, z
};

}  // namespace rob::motion
