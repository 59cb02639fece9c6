#pragma once

#include <algorithm>
#include <cmath>

#include "tests/motion/kinematics/arms.h"

/// forward(inverse(p)) = p, for every solution, over random poses of an arm; three in eight of them
/// in or beside a singular place. For a test, and with more poses for tests/bench.
namespace rob::test {

struct RoundTrip {
  double position = 0;       ///< greatest error, m
  double rotation = 0;       ///< greatest error, rad
  int poses = 0;             ///< that were tried
  int solutions = 0;         ///< of all of them
  int none = 0;              ///< poses without any
  int regular = 0;           ///< poses far from every singular place
  double regular_error = 0;  ///< of theirs the greatest, m or rad
  int lost = 0;              ///< of them: those whose joints are among no solution
};

/// rad: of the rotation from one to the other; exact for small ones, too.
inline double turn_between(const motion::Pose& a, const motion::Pose& b) {
  const Eigen::Quaterniond turn =
      a.orientation.normalized().conjugate() * b.orientation.normalized();
  return 2 * std::asin(std::min(1.0, turn.vec().norm()));
}

class PoseSource {
 public:
  PoseSource(const motion::ArmKinematics& arm, unsigned seed)
      : p_(arm.parameters()), random_(seed) {}

  motion::JointVector next() {
    motion::JointVector theta = random_joints(random_);
    switch (count_++ % 8) {
      case 0:  // axes 4 and 6 in line
        theta[4] = half_turns() + near();
        break;
      case 1:  // elbow straight or folded
        theta[2] = half_turns() - std::atan2(p_.a2, p_.c3) + near();
        break;
      case 2:
        put_on_axis_1(theta);
        break;
      default:
        break;
    }
    for (int i = 0; i < 6; ++i) {
      const auto at = static_cast<std::size_t>(i);
      theta[i] = p_.sign[at] * (theta[i] - p_.offset[at]);
    }
    return theta;
  }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double half_turns() { return uniform(0, 1) < 0.5 ? 0 : std::numbers::pi; }
  /// Exactly there, or off by 1e-15 … 0.1, rad or m.
  double near() {
    const double sign = uniform(0, 1) < 0.5 ? -1 : 1;
    return uniform(0, 1) < 0.1 ? 0 : sign * std::pow(10, uniform(-15, -1));
  }
  /// The wrist beside axis 1 by no more than b: a1 + c2·sin θ2 + k·sin(θ2 + θ3 + ψ) = 0.
  void put_on_axis_1(motion::JointVector& theta) {
    const double k = std::hypot(p_.a2, p_.c3);
    const double sine = (near() - p_.a1 - p_.c2 * std::sin(theta[1])) / k;
    if (std::abs(sine) > 1) return;
    theta[2] = std::asin(sine) - theta[1] - std::atan2(p_.a2, p_.c3);
  }

  motion::ArmParameters p_;
  std::mt19937 random_;
  int count_ = 0;
};

inline bool contains(const motion::InverseSolutions& found, const motion::JointVector& q,
                     double tolerance) {
  return std::any_of(found.begin(), found.end(), [&](const motion::JointVector& other) {
    return (other - q).cwiseAbs().maxCoeff() <= tolerance;
  });
}

/// Far enough from every singular place for joints to be as exact as poses.
inline bool is_regular(const motion::SingularityDistances& far) {
  return far.shoulder > 1e-3 && far.elbow > 1e-3 && far.wrist > 1e-3;
}

inline RoundTrip round_trip(const motion::ArmKinematics& arm, int poses, unsigned seed) {
  PoseSource source(arm, seed);
  RoundTrip trip;
  trip.poses = poses;
  for (int i = 0; i < poses; ++i) {
    const motion::JointVector q = source.next();
    const motion::Pose pose = arm.forward(q);
    const motion::InverseSolutions found = arm.solutions(pose, q);
    trip.solutions += found.count;
    if (found.count == 0) ++trip.none;
    double position = 0;
    double rotation = 0;
    for (const motion::JointVector& other : found) {
      const motion::Pose there = arm.forward(other);
      position = std::max(position, (there.position - pose.position).norm());
      rotation = std::max(rotation, turn_between(there, pose));
    }
    trip.position = std::max(trip.position, position);
    trip.rotation = std::max(trip.rotation, rotation);
    if (!is_regular(arm.singularities(q))) continue;
    trip.regular_error = std::max({trip.regular_error, position, rotation});
    ++trip.regular;
    if (!contains(found, q, 1e-9)) ++trip.lost;
  }
  return trip;
}

}  // namespace rob::test
