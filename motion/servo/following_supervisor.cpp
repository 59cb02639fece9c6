#include "motion/servo/following_supervisor.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "motion/servo/servo_law.h"

namespace rob::motion {
namespace {

using Verdict = FollowingFinding::Verdict;
using Cause = FollowingFinding::Cause;

constexpr double kWarnShare = 0.5;  // of the limit
// Of the way that overcomes Coulomb friction: at a reversal the integral still holds against it
// from the other side, so twice that way is needed; the third is the margin.
constexpr double kBreakawayMargin = 3;
// The share of following_warn: what is frozen is found before the error stops it.
constexpr double kLagShare = 0.25;

FollowingFinding stop(Cause cause, int axis, double value, double limit) noexcept {
  return {Verdict::Stop, cause, axis, value, limit};
}

}  // namespace

FollowingSupervisor::FollowingSupervisor(std::span<const DriveData> drives,
                                         const JointVector& v_max, const JointVector& a_max,
                                         double servo_period)
    : count_(static_cast<int>(drives.size())), servo_period_(servo_period) {
  assert(drives.size() <= axes_.size());
  for (std::size_t i = 0; i < drives.size(); ++i) {
    const DriveData& drive = drives[i];
    AxisWatch& axis = axes_[i];
    axis.v_max = v_max[static_cast<Eigen::Index>(i)];
    axis.limit_at_rest = drive.following_warn;
    axis.limit_at_v_max = drive.following_limit;
    const double omega = servo_bandwidth(drive, servo_period);
    axis.frozen_way =
        kFrozenCounts * drive.encoder_resolution +
        kBreakawayMargin * drive.coulomb_friction / servo_gains(drive, servo_period).kp +
        std::min(a_max[static_cast<Eigen::Index>(i)] / (omega * omega),
                 kLagShare * drive.following_warn);
  }
}

void FollowingSupervisor::reset(const JointReference& reference,
                                const JointMeasurement& measured) noexcept {
  time_ = measured.time;
  spread_ = 0;
  silent_ = 0;
  for (int i = 0; i < count_; ++i) {
    AxisWatch& axis = axes_[static_cast<std::size_t>(i)];
    axis.q = measured.q[i];
    axis.nearest = std::abs(reference.q[i] - measured.q[i]);
    axis.unchanged = 0;
  }
}

FollowingFinding FollowingSupervisor::check(DriverStatus status, const JointReference& reference,
                                            const JointVector& goal,
                                            const JointMeasurement& measured,
                                            double spread) noexcept {
  if (status != DriverStatus::Ok) return no_answer(status);
  silent_ = 0;
  const double elapsed = std::max(measured.time - time_, servo_period_) + spread + spread_;
  time_ = measured.time;
  spread_ = spread;
  FollowingFinding gravest;
  for (int i = 0; i < count_; ++i) {
    // The velocities are looked at for being numbers alone.
    const double rates = measured.qd[i] + reference.qdd[i];
    const FollowingFinding finding = std::isfinite(rates)
                                         ? check_axis(i, elapsed, measured.q[i], goal[i], reference)
                                         : stop(Cause::NotFinite, i, rates, 0);
    if (finding.verdict > gravest.verdict) gravest = finding;
  }
  return gravest;
}

FollowingFinding FollowingSupervisor::no_answer(DriverStatus status) noexcept {
  if (status == DriverStatus::Lost) return stop(Cause::Lost, -1, 0, 0);
  if (status == DriverStatus::Alarm) return stop(Cause::Alarm, -1, 0, 0);
  if (status != DriverStatus::Silent) return {};
  silent_ = std::min(silent_ + 1, kSilentCycles);
  if (silent_ < kSilentCycles) return {};
  return stop(Cause::Silent, -1, silent_, kSilentCycles);
}

FollowingFinding FollowingSupervisor::check_axis(int i, double elapsed, double q, double goal,
                                                 const JointReference& reference) noexcept {
  AxisWatch& axis = axes_[static_cast<std::size_t>(i)];
  const double q0 = reference.q[i];
  const double v0 = reference.qd[i];
  if (!std::isfinite(q + q0 + v0)) return stop(Cause::NotFinite, i, q, 0);

  const double moved = off_way(axis.q, goal, q);
  const double error = std::abs(q0 - q);
  const bool frozen = is_frozen(axis, q, error);
  axis.q = q;
  const double credible = kJumpMargin * axis.v_max * elapsed;
  if (moved > credible) return stop(Cause::Jump, i, moved, credible);

  if (frozen) return stop(Cause::Frozen, i, error - axis.nearest, axis.frozen_way);

  const double limit =
      std::max(axis.limit_at_rest, axis.limit_at_v_max * std::abs(v0) / axis.v_max);
  if (error > limit) return stop(Cause::FollowingError, i, error, limit);
  if (error > kWarnShare * limit) return {Verdict::Warn, Cause::FollowingError, i, error, limit};
  return {};
}

bool FollowingSupervisor::is_frozen(AxisWatch& axis, double q, double error) noexcept {
  if (q != axis.q) {
    axis.nearest = error;
    axis.unchanged = 0;
    return false;
  }
  axis.nearest = std::min(axis.nearest, error);
  axis.unchanged = std::min(axis.unchanged + 1, kFrozenCycles);
  return axis.unchanged == kFrozenCycles && error - axis.nearest > axis.frozen_way;
}

}  // namespace rob::motion
