#include "motion/plan/torque_share.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {
namespace {

/// A force on one axis at the share x of the speed: turning·x² + rising·x + standing.
struct Demand {
  double turning = 0;   ///< Coriolis and centrifugal
  double rising = 0;    ///< inertia and viscous friction
  double standing = 0;  ///< weight and Coulomb friction

  double full() const noexcept { return std::abs(turning + rising + standing); }
};

/// The smallest x > 0 at which the demand is `level`; 1 if that comes later.
double first_reach(const Demand& demand, double level) noexcept {
  const auto [a, b, standing] = demand;
  const double c = standing - level;
  const auto within = [](double x) { return x > 0 && x < 1 ? x : 1.0; };
  if (a == 0) return b == 0 ? 1 : within(-c / b);
  const double root = b * b - 4 * a * c;
  if (root < 0) return 1;
  // Both roots without cancellation (Numerical Recipes, 5.6).
  const double q = -0.5 * (b + std::copysign(std::sqrt(root), b));
  return std::min(within(q / a), q == 0 ? 1 : within(c / q));
}

void count(const Demand& demand, double most, int axis, TorqueShare& found) noexcept {
  const double share = demand.full() / most;
  if (share > found.share) {
    found.share = share;
    found.axis = axis;
  }
  const double bound = TorqueShare::kMost * most;
  const double speed = std::abs(demand.standing) >= bound
                           ? 0
                           : std::min(first_reach(demand, bound), first_reach(demand, -bound));
  found.speed = std::min(found.speed, speed);
}

double sign(double x) noexcept { return x > 0 ? 1 : x < 0 ? -1 : 0; }

}  // namespace

TorqueShare torque_share(const RobotModel& robot, const JointVector& q, const JointVector& qd,
                         const JointVector& qdd) noexcept {
  return torque_share(robot, robot.mechanics ? &*robot.mechanics : nullptr, q, qd, qdd);
}

TorqueShare torque_share(const RobotModel& robot, const ArmMechanics* mechanics,
                         const JointVector& q, const JointVector& qd,
                         const JointVector& qdd) noexcept {
  TorqueShare found;
  JointVector inertia = qdd;
  JointVector coriolis = JointVector::Zero(q.size());
  JointVector weight = JointVector::Zero(q.size());
  if (mechanics != nullptr) {
    const Ums7Dynamics& arm = mechanics->dynamics;
    inertia = arm.inertia(q).times(qdd);
    coriolis = arm.coriolis(q, qd);
    weight = arm.gravity(q);
  }
  for (int i = 0; i < robot.axis_count(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const DriveData& drive = robot.axes[at].drive;
    const double friction = drive.coulomb_friction * sign(qd[i]);
    const double viscous = drive.viscous_friction * qd[i];
    if (mechanics == nullptr) {
      count({0, drive.inertia * qdd[i] + viscous, friction}, drive.force_max, i, found);
      continue;
    }
    const auto& [Da, Db, torque_max] = mechanics->motors[at];
    count({coriolis[i], inertia[i], weight[i]}, torque_max, i, found);
    count({Da * coriolis[i], Da * inertia[i] + Db * qdd[i] + viscous, Da * weight[i] + friction},
          drive.force_max, i, found);
  }
  return found;
}

}  // namespace rob::motion
