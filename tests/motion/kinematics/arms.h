#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "motion/kinematics/arm_kinematics.h"
#include "motion/robots/robot_library.h"
#include "tests/support/degrees.h"

/// Arms whose Denavit-Hartenberg tables are published, multiplied out as homogeneous matrices: a
/// second way from joints to tool, which shares nothing with ArmKinematics.
namespace rob::test {

/// One row of a table: m, degrees. theta is what is added to the joint.
struct DhRow {
  double alpha;
  double a;
  double d;
  double theta;
};

struct PublishedArm {
  std::string name;  ///< of its robot file
  bool modified;     ///< Craig's convention: Rx(α)·Tx(a)·Rz(θ)·Tz(d), else Rz·Tz·Tx·Rx
  std::vector<DhRow> rows;
};

inline const std::vector<PublishedArm>& published_arms() {
  static const std::vector<PublishedArm> arms{
      // Corke, Armstrong-Helouvry 1994 (Robotics Toolbox, mdl_puma560)
      {"puma560",
       false,
       {{90, 0, 0, 0},
        {0, 0.4318, 0, 0},
        {-90, 0.0203, 0.15005, 0},
        {90, 0, 0.4318, 0},
        {-90, 0, 0, 0},
        {0, 0, 0, 0}}},
      // S3, Craig's convention
      {"pc104",
       true,
       {{0, 0, 0, 0},
        {-90, 0.150, 0, 0},
        {0, 0.570, 0, 0},
        {-90, 0.150, 0.650, 0},
        {90, 0, 0, 0},
        {-90, 0, 0, 0}}},
      // S4
      {"lwa4p",
       false,
       {{-90, 0, 0.205, 0},
        {180, 0.350, 0, -90},
        {-90, 0, 0, -90},
        {90, 0, 0.305, 0},
        {-90, 0, 0, 0},
        {0, 0, 0.075, 0}}},
      // ABB's measures as in ARTE (Gil, Universidad Miguel Hernández), robots/ABB/IRB120
      {"irb120",
       false,
       {{-90, 0, 0.290, 0},
        {0, 0.270, 0, -90},
        {-90, 0.070, 0, 0},
        {90, 0, 0.302, 0},
        {-90, 0, 0, 0},
        {0, 0, 0.072, 180}}},
  };
  return arms;
}

inline Eigen::Matrix4d dh_forward(const PublishedArm& arm, const motion::JointVector& q) {
  using Eigen::AngleAxisd;
  using Eigen::Translation3d;
  using Eigen::Vector3d;
  Eigen::Affine3d pose = Eigen::Affine3d::Identity();
  for (std::size_t i = 0; i < arm.rows.size(); ++i) {
    const DhRow& row = arm.rows[i];
    const double theta = q[static_cast<int>(i)] + row.theta * kDegree;
    const Eigen::Affine3d screw_x =
        AngleAxisd(row.alpha * kDegree, Vector3d::UnitX()) * Translation3d(row.a, 0, 0);
    const Eigen::Affine3d screw_z =
        AngleAxisd(theta, Vector3d::UnitZ()) * Translation3d(0, 0, row.d);
    pose = arm.modified ? pose * screw_x * screw_z : pose * screw_z * screw_x;
  }
  return pose.matrix();
}

inline Eigen::Matrix4d matrix_of(const motion::Pose& pose) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = pose.orientation.toRotationMatrix();
  matrix.topRightCorner<3, 1>() = pose.position;
  return matrix;
}

/// Greatest difference in m and in the entries of the rotation.
inline double difference(const motion::Pose& a, const motion::Pose& b) {
  return (matrix_of(a) - matrix_of(b)).cwiseAbs().maxCoeff();
}

inline const std::vector<std::string>& arm_names() {
  static const std::vector<std::string> names{"ums7", "pc104", "lwa4p", "puma560", "irb120"};
  return names;
}

inline std::shared_ptr<const motion::ArmKinematics> arm(const std::string& name) {
  return std::dynamic_pointer_cast<const motion::ArmKinematics>(
      motion::embedded_robot(name).kinematics);
}

inline motion::JointVector joints(std::initializer_list<double> degrees) {
  motion::JointVector q(static_cast<Eigen::Index>(degrees.size()));
  Eigen::Index i = 0;
  for (const double degree : degrees) q[i++] = degree * kDegree;
  return q;
}

inline motion::JointVector random_joints(std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-std::numbers::pi, std::numbers::pi);
  motion::JointVector q(6);
  for (double& value : q) value = angle(random);
  return q;
}

}  // namespace rob::test
