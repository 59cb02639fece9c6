#pragma once

#include <cstring>

#include <Eigen/Core>

namespace rob::motion {

inline constexpr int kMaxJoints = 8;

/// One value per axis: m or rad, or their rates. Lives wholly in the object (no heap), so it may be
/// used in the tick.
///
/// An Eigen vector whose copies are made in one piece, whatever its size: five times as fast as
/// value by value.
class JointVector
    : public Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxJoints, 1> {
 public:
  using Base = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxJoints, 1>;

  using Base::Base;
  JointVector() noexcept = default;
  ~JointVector() = default;
  JointVector(const JointVector& other) noexcept : Base() { copy(other); }
  JointVector& operator=(const JointVector& other) noexcept {
    copy(other);
    return *this;
  }
  template <typename Expression>
  JointVector(const Eigen::MatrixBase<Expression>& values) : Base(values) {}
  template <typename Expression>
  JointVector& operator=(const Eigen::MatrixBase<Expression>& values) {
    Base::operator=(values);
    return *this;
  }

 private:
  void copy(const JointVector& other) noexcept {
    std::memcpy(static_cast<void*>(this), static_cast<const void*>(&other), sizeof *this);
  }
};

/// Where every axis shall be at one instant, and how it is moving there. s, SI.
struct JointReference {
  double time = 0;
  JointVector q;
  JointVector qd;
  JointVector qdd;
};

/// The measurement of the servo at one instant. s, SI. Velocities are estimates.
struct JointMeasurement {
  double time = 0;
  JointVector q;
  JointVector qd;
};

}  // namespace rob::motion
