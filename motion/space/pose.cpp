#include "motion/space/pose.h"

#include <cmath>
#include <numbers>

namespace rob::motion {

namespace {

constexpr double kPi = std::numbers::pi;

/// atan2 gives −π for (−0, negative); the same direction is +π here.
double angle_of(double y, double x) {
  const double angle = std::atan2(y, x);
  return angle <= -kPi ? kPi : angle;
}

}  // namespace

Eigen::Quaterniond orientation_from(const FixedAngles& angles) {
  return Eigen::AngleAxisd(angles.c, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(angles.b, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(angles.a, Eigen::Vector3d::UnitX());
}

FixedAngles fixed_angles(const Eigen::Quaterniond& orientation) {
  // Below this cos b the entries that separate a from c are rounding noise. [choice: 1e-10, as for
  // the wrist's singularity; the angles are then still right to 1e-10 rad]
  constexpr double kNoHeading = 1e-10;
  const Eigen::Matrix3d r = orientation.toRotationMatrix();
  const double cos_b = std::hypot(r(0, 0), r(1, 0));
  const double b = std::atan2(-r(2, 0), cos_b);
  if (cos_b < kNoHeading) return {0.0, b, angle_of(-r(0, 1), r(1, 1))};
  return {angle_of(r(2, 1), r(2, 2)), b, angle_of(r(1, 0), r(0, 0))};
}

}  // namespace rob::motion
