#pragma once

#include "motion/kinematics/kinematics.h"

namespace rob::motion {

/// A gantry: two or three linear axes place the tool, one rotary axis after them may turn it.
/// Linear in the axes is linear in the world; there are no singularities.
class GantryKinematics final : public Kinematics {
 public:
  enum class Turn : std::uint8_t { AboutX, AboutY, AboutZ, None };

  /// S1's: x, y and theta, which turns about z.
  GantryKinematics() = default;
  /// linear: 2 (x, y in the plane z = 0) or 3 (x, y, z).
  GantryKinematics(int linear, Turn turn) : linear_(linear), turn_(turn) {}

  int axes() const noexcept override { return linear_ + (turn_ == Turn::None ? 0 : 1); }
  Pose forward(const JointVector& q) const noexcept override;
  /// Poses that need an axis which is not there have none.
  InverseSolutions solutions(const Pose& pose, const JointVector& near) const noexcept override;
  /// The flange is on the rotary axis.
  double lever(int axis, const Eigen::Vector3d& tip) const noexcept override;
  int coordinate(int axis) const noexcept override {
    return axis < linear_ ? axis : 3 + static_cast<int>(turn_);
  }
  bool shifts(int axis) const noexcept override { return axis < linear_; }
  LinkFrames frames(const JointVector& q) const noexcept override;
  const char* reach() const noexcept override;

 private:
  int linear_ = 2;
  Turn turn_ = Turn::AboutZ;
};

}  // namespace rob::motion
