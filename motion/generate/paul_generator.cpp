#include "motion/generate/paul_generator.h"

#include <algorithm>
#include <limits>

#include "motion/generate/limit_numbers.h"

namespace rob::motion {

PaulGenerator::PaulGenerator(const RobotModel& robot, LookAheadBuffer& buffer,
                             const JointVector& start)
    : SegmentGenerator(robot, buffer, start),
      reserve_(axis_reserve(robot)),
      usual_t_acc_(robot.t_acc),
      clock_(time_scale_limits(robot), robot.reference_period),
      tightest_(robot.t_acc) {
  end_path();
}

void PaulGenerator::set_override(double share) noexcept {
  SegmentGenerator::set_override(share);
  aim_clock();
  if (may_jump()) clock_.jump();
}

/// Of the planned speed, as much as the LivePace of the motion leaves.
double PaulGenerator::live_share() noexcept {
  if (!segment().live.present()) return 1;
  return std::min(1.0, live_rate(segment()) * segment().duration);
}

void PaulGenerator::aim_clock() noexcept {
  if (braking()) brake_harder();
  const double live = live_share();
  clock_.set_override(override_share() * live);
  stopping() || live == 0 ? clock_.hold() : clock_.resume();
}

/// What ends early, and began at rest, is slowed down as its own speeds permit: slow ones far
/// sooner than the greatest of the robot, which a hold may find anywhere.
void PaulGenerator::brake_harder() noexcept {
  if (!from_rest_ || !on_path() || inserted_ || segment().profile.present()) return;
  if (clock_.steady()) clock_.set_limits(time_scale_limits(segment().reserve, tightest_));
}

/// At the very beginning of a motion from rest, or at the end of a stop.
bool PaulGenerator::may_jump() const noexcept {
  const double now = clock_.path_time();
  if (!on_path()) return false;  // the clock knows
  if (segment().ends_at_rest() && now >= end_ - kSameInstant) return true;
  return from_rest_ && now <= end_ - segment().span() + kSameInstant;
}

void PaulGenerator::go_on_to_stamp() noexcept {
  adapt_clock();
  aim_clock();
  clock_.advance(stamp(), !on_path());
}

void PaulGenerator::adapt_clock() noexcept {
  const double tightest = buffer().tightest();
  if (tightest >= tightest_ || !clock_.steady()) return;
  clock_.set_limits(time_scale_limits(reserve_, tightest));
  tightest_ = tightest;
}

bool PaulGenerator::fits(const SegmentDescriptor& next) const noexcept {
  return !(next.t_acc < tightest_);
}

void PaulGenerator::pass_targets() noexcept {
  if (passed(passing_) || clock_.path_time() < milestone_ - kSameInstant) return;
  pass(passing_, clock_.run_time(milestone_));
}

double PaulGenerator::end() const noexcept {
  const bool comes = clock_.path_time() >= end_ - kSameInstant;
  return comes ? clock_.run_time(end_) : std::numeric_limits<double>::infinity();
}

void PaulGenerator::decide(double instant) noexcept {
  if (segment().ends_at_rest()) return follow_from_rest(instant);
  const bool nothing_else = closed();  // before looking: all that was pushed is then seen
  const SegmentDescriptor* const next = next_to_begin();
  if (next != nullptr && (next->from_rest || next->jog->present())) return begin_stop();
  if (next != nullptr && take_up(*next, instant)) return pop_segment();
  if (!nothing_else) tell_late_decision(instant);
  begin_stop();
}

/// What begins at the end of a segment begins exactly there.
double PaulGenerator::path_instant(double instant) const noexcept {
  if (!running()) return clock_.path_time();
  return segment().dwell ? clock_.path_time_at(instant) : end_;
}

/// S1: A := X, B := C, C := D, T1 := T2, t := −t_acc.
void PaulGenerator::begin(const SegmentDescriptor& next, double instant) noexcept {
  const double now = path_instant(instant);
  const std::uint32_t before = segment().number;
  const double t_acc = segment().t_acc;
  inserted_ = false;
  if (clock_.steady()) clock_.set_limits(time_scale_limits(reserve_, tightest_));
  if (next.profile.present()) return begin_profile(next, now);
  from_rest_ = !running() || segment().ends_at_rest();
  const JointVector b = segment().target;
  const JointVector a = from_rest_ ? b : path_.sample(exit()).q;
  zero_ = now + t_acc;
  end_ = zero_ + next.duration - next.t_acc;
  if (next.no_length) {
    path_.stop(a, b, t_acc, next.duration);
    path_events_.stop(t_acc);
  } else {
    path_.begin(next, a, b, t_acc, from_rest_);
    path_events_.begin(next, zero_, t_acc, from_rest_, now, clock_.override_share());
  }
  segment() = next;
  milestone_ = next.no_length ? end_ : zero_;
  passing_ = next.no_length ? next.number : before;
  aim_clock();
  if (from_rest_) clock_.jump();
}

/// From rest to rest in its own time.
void PaulGenerator::begin_profile(const SegmentDescriptor& next, double instant) noexcept {
  path_.begin(next, segment().target, segment().target, segment().t_acc, true);
  path_events_.begin(next, instant, 0, true, instant, clock_.override_share());
  segment() = next;
  from_rest_ = true;
  zero_ = instant;
  end_ = milestone_ = instant + next.duration;
  passing_ = next.number;
}

/// Arrives at the present target and stands there; the present segment goes on owning the time.
void PaulGenerator::begin_stop() noexcept {
  SegmentDescriptor stop = segment();
  stop.duration = 2 * stop.t_acc;
  stop.no_length = true;
  stop.profile = {};
  stop.limit = limit_number::kEndOfBuffer;
  begin(stop, clock_.run_time(end_));
  inserted_ = true;
}

void PaulGenerator::end_path() noexcept {
  const double t = on_path() ? sigma() : exit();
  segment().dwell = inserted_ = false;
  segment().profile = {};
  segment().live = {};
  segment().t_acc = usual_t_acc_;
  segment().duration = t + usual_t_acc_;
  path_events_.drop();
}

/// The chain rule: q' and q'' are along the path's time, which runs at the rate r.
void PaulGenerator::sample_path(GeneratorSample& sample) const noexcept {
  const double r = clock_.rate();
  const PathPoint p = path_.sample(sigma());
  sample.reference.q = p.q;
  sample.reference.qd = p.qd * r;
  sample.reference.qdd = p.qdd * (r * r) + p.qd * clock_.slope();
  sample.sigma = sigma();
  sample.rate = r;
  const bool slowed = clock_.override_share() < 1 && !inserted_;
  const bool paced = slowed && clock_.override_share() < override_share();
  sample.limit = paced ? limit_number::kPace : slowed ? limit_number::kOverride : segment().limit;
}

double PaulGenerator::share_done() const noexcept {
  return end_ > zero_ ? sigma() / (end_ - zero_) : 1;
}

std::optional<double> PaulGenerator::stands_since() const noexcept {
  return clock_.held() ? std::optional(clock_.steady_since()) : std::nullopt;
}

std::uint32_t PaulGenerator::decided() const noexcept {
  const bool due = inserted_ || clock_.next() > end_ + kSameInstant;
  return due ? segment().number : segment().number - 1;
}

const Effect* PaulGenerator::take_path_event(double until, std::uint32_t number,
                                             double& due) noexcept {
  const double path_time = clock_.passed_by(until) + kSameInstant;
  const Effect* const effect = path_events_.take(path_time, number, due);
  if (effect == nullptr) return nullptr;
  due = clock_.run_time(due);
  tell_cut_lead(*effect, due, path_events_.cut());
  return effect;
}

}  // namespace rob::motion
