#include "motion/generate/paul_generator.h"

#include <algorithm>
#include <limits>

#include "motion/generate/limit_numbers.h"

namespace rob::motion {

PaulLaw::PaulLaw(const RobotModel& robot, LookAheadBuffer& buffer, UnderWay& now,
                 EventQueue& events)
    : PathLaw(now, events),
      buffer_(buffer),
      reserve_(axis_reserve(robot)),
      usual_t_acc_(robot.t_acc),
      clock_(time_scale_limits(robot), robot.reference_period),
      tightest_(robot.t_acc) {
  end_path();
}

void PaulLaw::take_share() noexcept {
  aim_clock();
  if (may_jump()) clock_.jump();
}

/// The share of the planned speed that the LivePace of the motion leaves.
double PaulLaw::live_share() noexcept {
  if (!now_.segment.live.present()) return 1;
  return std::min(1.0, live_rate(now_.segment) * now_.segment.duration);
}

void PaulLaw::aim_clock() noexcept {
  if (now_.orders.brake) brake_harder();
  const double live = live_share();
  clock_.set_override(now_.orders.share * live);
  now_.orders.stop || live == 0 ? clock_.hold() : clock_.resume();
}

/// A motion that ends early, and began at rest, is slowed down as its own speeds permit: slow ones
/// far sooner than the greatest of the robot, which a hold may find anywhere.
void PaulLaw::brake_harder() noexcept {
  if (!from_rest_ || !now_.on_path() || inserted_ || now_.segment.profile.present()) return;
  if (clock_.steady()) clock_.set_limits(time_scale_limits(now_.segment.reserve, tightest_));
}

/// At the very beginning of a motion from rest, or at the end of a stop.
bool PaulLaw::may_jump() const noexcept {
  const double now = clock_.path_time();
  if (!now_.on_path()) return false;  // the clock knows
  if (now_.segment.ends_at_rest() && now >= end_ - kSameInstant) return true;
  return from_rest_ && now <= end_ - now_.segment.span() + kSameInstant;
}

PathLaw::News PaulLaw::go_on_to_stamp() noexcept {
  adapt_clock();
  aim_clock();
  clock_.advance(now_.stamp, !now_.on_path());
  return {};
}

void PaulLaw::adapt_clock() noexcept {
  const double tightest = buffer_.tightest();
  if (tightest >= tightest_ || !clock_.steady()) return;
  clock_.set_limits(time_scale_limits(reserve_, tightest));
  tightest_ = tightest;
}

std::optional<PathLaw::Passed> PaulLaw::passed(std::uint32_t known) const noexcept {
  if (known >= passing_ || clock_.path_time() < milestone_ - kSameInstant) return std::nullopt;
  return Passed{passing_, clock_.run_time(milestone_)};
}

double PaulLaw::end() const noexcept {
  const bool comes = clock_.path_time() >= end_ - kSameInstant;
  return comes ? clock_.run_time(end_) : std::numeric_limits<double>::infinity();
}

/// A motion that begins at the end of a segment begins exactly there.
double PaulLaw::path_instant(double instant) const noexcept {
  if (!now_.running) return clock_.path_time();
  return now_.segment.dwell ? clock_.path_time_at(instant) : end_;
}

/// S1: A := X, B := C, C := D, T1 := T2, t := −t_acc.
void PaulLaw::begin(const SegmentDescriptor& next, double instant) noexcept {
  const double now = path_instant(instant);
  const std::uint32_t before = now_.segment.number;
  const double t_acc = now_.segment.t_acc;
  inserted_ = false;
  if (clock_.steady()) clock_.set_limits(time_scale_limits(reserve_, tightest_));
  if (next.profile.present()) return begin_profile(next, now);
  from_rest_ = !now_.running || now_.segment.ends_at_rest();
  const JointVector b = now_.segment.target;
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
  now_.segment = next;
  milestone_ = next.no_length ? end_ : zero_;
  passing_ = next.no_length ? next.number : before;
  aim_clock();
  if (from_rest_) clock_.jump();
}

/// From rest to rest in its own time.
void PaulLaw::begin_profile(const SegmentDescriptor& next, double instant) noexcept {
  path_.begin(next, now_.segment.target, now_.segment.target, now_.segment.t_acc, true);
  path_events_.begin(next, instant, 0, true, instant, clock_.override_share());
  now_.segment = next;
  from_rest_ = true;
  zero_ = instant;
  end_ = milestone_ = instant + next.duration;
  passing_ = next.number;
}

/// A stop of its own: the segment goes on owning the time.
void PaulLaw::stop() noexcept {
  SegmentDescriptor stop = now_.segment;
  stop.duration = 2 * stop.t_acc;
  stop.no_length = true;
  stop.profile = {};
  stop.limit = limit_number::kEndOfBuffer;
  begin(stop, clock_.run_time(end_));
  inserted_ = true;
}

void PaulLaw::end_path() noexcept {
  const double t = now_.on_path() ? sigma() : exit();
  now_.segment.dwell = inserted_ = false;
  now_.segment.profile = {};
  now_.segment.live = {};
  now_.segment.t_acc = usual_t_acc_;
  now_.segment.duration = t + usual_t_acc_;
  path_events_.drop();
}

/// The chain rule: q' and q'' are along the path's time, which runs at the rate r.
void PaulLaw::sample_path(GeneratorSample& sample) const noexcept {
  const double r = clock_.rate();
  const PathPoint p = path_.sample(sigma());
  sample.reference.q = p.q;
  sample.reference.qd = p.qd * r;
  sample.reference.qdd = p.qdd * (r * r) + p.qd * clock_.slope();
  sample.sigma = sigma();
  sample.rate = r;
  const bool slowed = clock_.override_share() < 1 && !inserted_;
  const bool paced = slowed && clock_.override_share() < now_.orders.share;
  sample.limit = paced    ? limit_number::kPace
                 : slowed ? limit_number::kOverride
                          : now_.segment.limit;
}

double PaulLaw::share_done() const noexcept { return end_ > zero_ ? sigma() / (end_ - zero_) : 1; }

std::optional<double> PaulLaw::stands_since() const noexcept {
  return clock_.held() ? std::optional(clock_.steady_since()) : std::nullopt;
}

std::uint32_t PaulLaw::decided() const noexcept {
  const bool due = inserted_ || clock_.next() > end_ + kSameInstant;
  return due ? now_.segment.number : now_.segment.number - 1;
}

PathLaw::DueEvent PaulLaw::take_path_event(double until, std::uint32_t number) noexcept {
  const double path_time = clock_.passed_by(until) + kSameInstant;
  double due = 0;
  const Effect* const effect = path_events_.take(path_time, number, due);
  if (effect == nullptr) return {};
  return {effect, clock_.run_time(due), path_events_.cut()};
}

}  // namespace rob::motion
