#include "runtime/tick/force_watch.h"

namespace rob::runtime {

using motion::FollowingFinding;

namespace {

/// The share of the robot's limit, for a program that brakes by itself when that is passed.
/// [choice] what is gone until the axes stand, at S4's 5 mm/s against its stiffest cell, is a third
constexpr double kForPrograms = 1.5;

/// s in which a sensor must say something new (fault 21).
constexpr double kInsensible = 0.1;

}  // namespace

/// A program that brakes by itself in the cycle in which the limit is passed has more room.
FollowingFinding ForceWatch::judge(const motion::Wrench& felt, bool braking) noexcept {
  const double force = felt.force.norm();
  if (limit_ == 0 || force <= limit_) {
    beyond_ = 0;
    yielding_ = false;
    return {};
  }
  yielding_ = yielding_ || braking;
  if (force <= kForPrograms * limit_ && (yielding_ || ++beyond_ < 2)) return {};
  Eigen::Index axis = 0;
  felt.force.cwiseAbs().maxCoeff(&axis);
  return {FollowingFinding::Verdict::Stop, FollowingFinding::Cause::Force, static_cast<int>(axis),
          felt.force[axis], limit_};
}

FollowingFinding judge_sensor(const ForceGauge& gauge, double now) noexcept {
  const double since = gauge.insensible_for(now);
  if (since <= kInsensible) return {};
  return {FollowingFinding::Verdict::Stop, FollowingFinding::Cause::Insensible, -1, since,
          kInsensible};
}

}  // namespace rob::runtime
