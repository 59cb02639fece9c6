#include "runtime/tick/stopping.h"

namespace rob::runtime {

using motion::FollowingFinding;
using motion::MotionEvent;

Stopping::Stopping(const motion::RobotModel& robot, Tracks& tracks, Retracing& retracing,
                   Effects& effects, Channels& channels)
    : tracks_(tracks),
      retracing_(retracing),
      effects_(effects),
      channels_(channels),
      last_stop_(robot) {}

void Stopping::take(const ServoSample& sample, double now) noexcept {
  take_finding(sample.time, sample.finding, now);
  last_stop_.take(sample);
}

void Stopping::take_finding(double time, const FollowingFinding& finding, double now) noexcept {
  using Verdict = FollowingFinding::Verdict;
  if (finding.verdict == Verdict::None) return;
  const bool stop = finding.verdict == Verdict::Stop;
  if (stop && finding.cause == FollowingFinding::Cause::Overrun) lose_touch(now);
  if (faulted_ || (warned_ && !stop)) return;
  channels_.notices.push({time, finding});
  warned_ = true;
  if (stop) fail(now);
}

void Stopping::fail(double now) noexcept {
  faulted_ = true;
  hold(now);
}

void Stopping::pause(bool asked) noexcept {
  if (for_good_ || retracing_.pause(asked, paused_) || asked == paused_) return;
  paused_ = asked;
  if (asked) return tracks_.hold();
  retracing_.go_on();
  tracks_.resume();
}

void Stopping::hold(double now) noexcept {
  if (pausing()) tracks_.resume();  // so that they report anew that they stand
  tracks_.hold();
  retracing_.halt();
  if (for_good_) return;
  for_good_ = true;
  effects_.take_safe_values(now);
}

void Stopping::brake(double now) noexcept {
  disables_ = true;
  if (last_stop_.braking()) return;
  hold(now);
  last_stop_.brake(tracks_.reference());
}

void Stopping::lead(double stamp) noexcept {
  Track& track = tracks_.active();
  if (!last_stop_.lead(track.current, stamp)) return;
  track.pending.push(
      {.kind = MotionEvent::Kind::Held, .time = last_stop_.rest(), .tag = track.current.tag});
  if (disables_) channels_.drives_off.store(true, std::memory_order_relaxed);
}

}  // namespace rob::runtime
