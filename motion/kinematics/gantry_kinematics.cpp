#include "motion/kinematics/gantry_kinematics.h"

#include <algorithm>
#include <cmath>

#include "base/unit_factors.h"

namespace rob::motion {

Pose GantryKinematics::forward(const JointVector& q) const noexcept {
  Pose pose{Eigen::Vector3d::Zero(), Eigen::Quaterniond::Identity()};
  pose.position.head(linear_) = q.head(linear_);
  if (turn_ == Turn::None) return pose;
  const double half = q[linear_] / 2;
  pose.orientation.w() = std::cos(half);
  pose.orientation.vec()[static_cast<int>(turn_)] = std::sin(half);
  return pose;
}

LinkFrames GantryKinematics::frames(const JointVector& q) const noexcept {
  LinkFrames frames;
  for (int i = 0; i < linear_; ++i)
    frames[static_cast<std::size_t>(i)].position.head(i + 1) = q.head(i + 1);
  std::fill(frames.begin() + linear_, frames.end(), forward(q));
  return frames;
}

InverseSolutions GantryKinematics::solutions(const Pose& pose,
                                             const JointVector& near) const noexcept {
  // m, and rad as the sine of half an angle. [choice] far above rounding, far below an encoder.
  constexpr double kBeside = 1e-9;
  Eigen::Vector3d place_left = pose.position;
  Eigen::Vector3d turn_left = pose.orientation.vec();
  place_left.head(linear_).setZero();
  if (turn_ != Turn::None) turn_left[static_cast<int>(turn_)] = 0;
  InverseSolutions found;
  if (!(place_left.norm() <= kBeside && turn_left.norm() <= kBeside)) return found;
  if (!pose.position.allFinite()) return found;
  found.count = 1;
  JointVector& q = found.q[0];
  q.resize(axes());
  q.head(linear_) = pose.position.head(linear_);
  if (turn_ == Turn::None) return found;
  const double half_sine = pose.orientation.vec()[static_cast<int>(turn_)];
  const double angle = 2 * std::atan2(half_sine, pose.orientation.w());
  q[linear_] = near[linear_] + std::remainder(angle - near[linear_], kFullTurn);
  return found;
}

double GantryKinematics::lever(int axis, const Eigen::Vector3d& tip) const noexcept {
  if (axis < linear_) return 0;
  Eigen::Vector3d across = tip;
  across[static_cast<int>(turn_)] = 0;
  return across.norm();
}

const char* GantryKinematics::reach() const noexcept {
  constexpr const char* kWords[2][4] = {
      {"places its tool in the plane z = 0mm and turns it about x alone",
       "places its tool in the plane z = 0mm and turns it about y alone",
       "places its tool in the plane z = 0mm and turns it about z alone",
       "places its tool in the plane z = 0mm and does not turn it"},
      {"turns its tool about x alone", "turns its tool about y alone",
       "turns its tool about z alone", "does not turn its tool"}};
  return kWords[linear_ - 2][static_cast<std::size_t>(turn_)];
}

}  // namespace rob::motion
