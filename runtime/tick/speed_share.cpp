#include "runtime/tick/speed_share.h"

#include <algorithm>

namespace rob::runtime {

using motion::FollowingFinding;

namespace {

constexpr double kMostShare = 2;  // of an override

}  // namespace

SpeedShare::SpeedShare(const motion::RobotModel& robot, double override_share, Tracks& tracks,
                       Channels& channels)
    : tracks_(tracks),
      channels_(channels),
      scales_time_(robot.law == motion::Law::Paul),
      most_share_(scales_time_ ? 1 : kMostShare),
      override_share_(std::min(override_share, most_share_)),
      relief_(robot.reference_period) {
  if (override_share_ != 1) set_override(override_share_);
}

/// The planner sees to what the law cannot follow: it has raised what comes from here on.
void SpeedShare::set_override(double share) noexcept {
  override_share_ = std::min(share, most_share_);
  tracks_.set_override(this->share());
}

double SpeedShare::share() const noexcept {
  return relief_.share() < 1 ? std::min(override_share_, relief_.share()) : override_share_;
}

void SpeedShare::relieve_drives(double now, double saturation) noexcept {
  const double before = share();
  const double rate = tracks_.active().current.rate;
  relief_.update(saturation, scales_time_ || rate == 0 ? rate : share());
  if (share() != before) set_override(override_share_);
  if (relief_.share() == 1 || reported_) return;
  reported_ = true;
  using Cause = FollowingFinding::Cause;
  channels_.notices.push(
      {now, {FollowingFinding::Verdict::Warn, Cause::Saturated, -1, saturation, 1}});
}

}  // namespace rob::runtime
