#include "motion/space/rotation.h"

#include <cmath>

namespace rob::motion {

Eigen::Quaterniond rotation_by(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  Eigen::Quaterniond turn;
  turn.w() = std::cos(angle / 2);
  // sin(x/2)/x → 1/2
  turn.vec() = vector * (angle > 0 ? std::sin(angle / 2) / angle : 0.5);
  return turn;
}

Eigen::Vector3d rotation_vector(const Eigen::Quaterniond& turn) {
  const double sine = turn.vec().norm();
  const double sign = turn.w() < 0 ? -1 : 1;
  const double half = std::atan2(sine, std::abs(turn.w()));
  return turn.vec() * (sign * (sine > 0 ? 2 * half / sine : 2.0));
}

}  // namespace rob::motion
