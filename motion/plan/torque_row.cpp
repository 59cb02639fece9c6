#include "motion/plan/torque_row.h"

#include <algorithm>
#include <cmath>

#include "motion/plan/torque_share.h"

namespace rob::motion {

namespace {

/// The part of `most` that motion may use if standing still needs `standing`; always above 0.
double left_of(double most, double standing) noexcept {
  constexpr double kLeast = 1e-3;  // [choice] where overload() has refused the motion
  const double left = most - standing;
  return std::max({TorqueShare::kMost * most - standing, left / 2, kLeast * most});
}

}  // namespace

void TorqueRow::take(const TorqueRow& other) noexcept {
  if (other.slope > slope || axis < 0) axis = other.axis;
  slope = std::max(slope, other.slope);
  bend = std::max(bend, other.bend);
  fastest = std::min(fastest, other.fastest);
}

TorqueRow torque_row(const RobotModel& robot, const ArmMechanics& arm, const PathPoint& place,
                     double rate) noexcept {
  const auto& [q, slope, bend] = place;
  const ArmInertia inertia = arm.dynamics.inertia(q);
  const JointVector rising = inertia.times(slope);
  const JointVector turning = inertia.times(bend) + arm.dynamics.coriolis(q, slope);
  const JointVector weight = arm.dynamics.gravity(q);
  TorqueRow row;
  const auto take = [&](double of_slope, double of_bend, double left, int axis) {
    row.take({std::abs(of_slope) / left, std::abs(of_bend) / left, row.fastest, axis});
  };
  for (int i = 0; i < q.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const DriveData& drive = robot.axes[at].drive;
    const auto& [Da, Db, torque_max] = arm.motors[at];
    take(rising[i], turning[i], left_of(torque_max, std::abs(weight[i])), i);
    const double standing = Da * std::abs(weight[i]) + drive.coulomb_friction;
    double left = left_of(drive.force_max, standing);
    if (const double viscous = drive.viscous_friction * std::abs(slope[i]); viscous > 0) {
      row.fastest = std::min(row.fastest, left / (2 * viscous));
      left -= viscous * std::min(rate, left / (2 * viscous));
    }
    take(Da * rising[i] + Db * slope[i], Da * turning[i] + Db * bend[i], left, i);
  }
  return row;
}

std::optional<Overload> overload(const RobotModel& robot, const ArmMechanics& arm,
                                 const JointVector& q) noexcept {
  const JointVector weight = arm.dynamics.gravity(q);
  for (int i = 0; i < q.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto& [Da, Db, torque_max] = arm.motors[at];
    const double borne = std::abs(weight[i]);
    if (borne >= torque_max) return Overload{i, borne, torque_max};
    const double force_max = robot.axes[at].drive.force_max;
    if (Da * borne >= force_max) return Overload{i, Da * borne, force_max};
  }
  return std::nullopt;
}

}  // namespace rob::motion
