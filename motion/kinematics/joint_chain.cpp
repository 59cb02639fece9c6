#include "motion/kinematics/joint_chain.h"

#include <array>
#include <cmath>
#include <utility>

namespace rob::motion {

JointChain::JointChain(std::vector<ChainJoint> joints, const Pose& flange)
    : joints_(std::move(joints)), flange_(flange) {
  for (const ChainJoint& joint : joints_)
    steps_.push_back({joint.place.orientation.toRotationMatrix(), joint.place.position});
}

Pose JointChain::walk(const JointVector& q, Jacobian* jacobian) const noexcept {
  std::array<Eigen::Vector3d, kMaxJoints> points;
  std::array<Eigen::Vector3d, kMaxJoints> directions;
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const double value = q[static_cast<Eigen::Index>(i)];
    place += turn * steps_[i].place;
    turn = (turn * steps_[i].turn).eval();
    points[i] = place;
    directions[i] = turn.col(2);
    if (joints_[i].linear) {
      place += value * turn.col(2);
      continue;
    }
    const double s = std::sin(value);
    const double c = std::cos(value);
    const Eigen::Vector3d x = turn.col(0);
    turn.col(0) = c * x + s * turn.col(1);
    turn.col(1) = c * turn.col(1) - s * x;
  }
  Pose pose{place + turn * flange_.position, Eigen::Quaterniond(turn) * flange_.orientation};
  pose.orientation.normalize();
  if (jacobian == nullptr) return pose;
  jacobian->setZero();
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    auto column = jacobian->col(static_cast<Eigen::Index>(i));
    if (joints_[i].linear) {
      column.head<3>() = directions[i];
    } else {
      column << directions[i].cross(pose.position - points[i]), directions[i];
    }
  }
  return pose;
}

std::vector<JointChain::Line> JointChain::lines(const JointVector& q) const {
  std::vector<Line> lines;
  Pose pose;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    pose = composed(pose, joints_[i].place);
    const Eigen::Vector3d z = pose.orientation * Eigen::Vector3d::UnitZ();
    lines.push_back({pose.position, z});
    const double value = q[static_cast<Eigen::Index>(i)];
    if (joints_[i].linear) pose.position += value * z;
    if (!joints_[i].linear)
      pose.orientation =
          pose.orientation * Eigen::Quaterniond(std::cos(value / 2), 0, 0, std::sin(value / 2));
  }
  return lines;
}

}  // namespace rob::motion
