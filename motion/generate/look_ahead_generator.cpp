#include "motion/generate/look_ahead_generator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/generate/limit_numbers.h"

namespace rob::motion {

namespace {

/// [choice] jogs and profiles are slowed by it, the path follows it up to here
constexpr double kMostShare = 2;

constexpr double kAnyPace = std::numeric_limits<double>::infinity();

bool has_way(const SegmentDescriptor& segment) noexcept {
  return segment.ahead.length > 0 && !segment.no_length && !segment.dwell &&
         !segment.jog->present() && !segment.profile.present();
}

/// σ that differ by less are one place: rounding of the sum of a path's lengths.
double rounding(double sigma) noexcept { return 1e-12 * (1 + std::abs(sigma)); }

std::uint8_t number_of(const GuideLimit& limit) noexcept {
  using namespace limit_number;
  switch (limit.kind) {
    case GuideLimit::Kind::Pace:
      return kPace;
    case GuideLimit::Kind::Override:
      return kOverride;
    case GuideLimit::Kind::EndOfPath:
      return kEndOfBuffer;
    case GuideLimit::Kind::Speed:
      return limit.axis < 0 ? kNone : of_axis(kSpeed, limit.axis);
    case GuideLimit::Kind::Acceleration:
    case GuideLimit::Kind::Braking:
      return limit.axis < 0 ? kNone : of_axis(kAcceleration, limit.axis);
    case GuideLimit::Kind::None:
      break;
  }
  return kNone;
}

}  // namespace

LookAheadGenerator::LookAheadGenerator(const RobotModel& robot, LookAheadBuffer& buffer,
                                       PathRing& ring, const JointVector& start)
    : SegmentGenerator(robot, buffer, start),
      ring_(ring),
      guide_(ring, start),
      average_(ring, start),
      events_(guide_, average_, robot.reference_period),
      clock_(time_scale_limits(robot), robot.reference_period) {
  guide_.brake();
}

void LookAheadGenerator::set_override(double share) noexcept {
  SegmentGenerator::set_override(share);
  clock_.set_override(share);
  ring_.share.store(std::min(override_share(), kMostShare), std::memory_order_relaxed);
}

const SegmentDescriptor* LookAheadGenerator::next_segment() const noexcept {
  const PathLeg* const leg = dropping_ ? nullptr : ring_.next_leg();
  return leg == nullptr ? nullptr : &leg->segment;
}

void LookAheadGenerator::pop_segment() noexcept { ring_.pop_leg(); }

bool LookAheadGenerator::begins_at_stamp(const SegmentDescriptor& next) const noexcept {
  return has_way(next) || next.jog->present() || next.profile.present();
}

void LookAheadGenerator::skip(double gap) noexcept {
  skipped_ += gap;
  clock_.skip(gap);
}

void LookAheadGenerator::go_on_to_stamp() noexcept {
  if (dropping_ && ring_.drop_done()) finish_drop();
  stopping() ? clock_.hold() : clock_.resume();
  clock_.advance(stamp(), !(on_path() && profiled()));
  step_guide();
  const std::uint32_t late = ring_.late.load(std::memory_order_relaxed);
  for (; late_ != late; ++late_) tell_late_decision(stamp());
}

/// Where no path is followed it stands, and its time goes on.
void LookAheadGenerator::step_guide() noexcept {
  const bool runs = on_run();
  const double pace = runs ? live_pace() : kAnyPace;
  runs && !stopping() && pace > 0 ? guide_.release() : guide_.brake();
  guide_.set_share(std::min(override_share(), kMostShare));
  guide_.set_pace(pace);
  guide_.step(guide_time(), [this](const Guide::Part& part) noexcept { history_.keep(part); });
  ring_.sigma.store(guide_.sigma(), std::memory_order_relaxed);
  ring_.rate.store(guide_.rate(), std::memory_order_relaxed);
  ring_.periods.fetch_add(1, std::memory_order_relaxed);
  if (!runs) return events_.stand(guide_time());
  average_.take(guide_);
  events_.go_on({guide_time(), average_.sigma(), average_.rate()});
  tell_missed_leads();
  history_.forget(guide_time() - lag() - period());  // what was passed in this period is kept
  released_ = std::max(released_, average_.oldest());
  ring_.release(released_);
}

/// σ' that the motion on which the guide is, ahead of the references, may have.
double LookAheadGenerator::live_pace() noexcept {
  const SegmentDescriptor* const leg = guide_.sigma() < end_ ? &segment() : next_segment();
  const bool paced = leg != nullptr && leg->live.present();  // of no length there is no share
  return paced ? live_rate(*leg) * leg->ahead.length : kAnyPace;
}

void LookAheadGenerator::tell_missed_leads() noexcept {
  while (const auto missed = events_.take_missed(period())) {
    tell({.kind = MotionEvent::Kind::LeadMissed,
          .time = missed->time + skipped_,
          .tag = missed->tag,
          .value = missed->error});
  }
}

bool LookAheadGenerator::beyond_end() const noexcept { return cursor() > end_ + rounding(end_); }

void LookAheadGenerator::pass_targets() noexcept {
  const double arrived = end();
  if (arrived <= stamp() + kSameInstant && !passed(segment().number)) {
    pass(segment().number, arrived);
  }
  while (on_run() && beyond_end()) {
    const PathLeg* const next = ring_.next_leg();
    const auto when = passed_end();
    if (next == nullptr || !when) return;
    if (!passed(segment().number)) pass(segment().number, *when);
    if (!take_up(next->segment, *when)) return;
    pop_segment();
  }
}

/// When the references passed the end of the motion. Without a mean they are the guide, whose
/// instants are exact; else their σ is known at each stamp.
std::optional<double> LookAheadGenerator::passed_end() const noexcept {
  if (average_.periods() > 1) return events_.passing(end_) + skipped_;
  const auto when = history_.when(end_, guide_time());
  return when ? std::optional(*when + skipped_) : std::nullopt;
}

/// Of a run: when the references came to rest at its end.
double LookAheadGenerator::arrival() const noexcept {
  const bool there = guide_.at_run_end() && average_.stands() && !beyond_end();
  if (!there) return std::numeric_limits<double>::infinity();
  return std::min(told(history_.stands_since()) + lag(), stamp());
}

double LookAheadGenerator::end() const noexcept {
  if (on_run()) return arrival();
  if (!profiled()) return arrival_;
  const double end = zero_ + segment().duration;
  const bool comes = clock_.path_time() >= end - kSameInstant;
  return comes ? clock_.run_time(end) : std::numeric_limits<double>::infinity();
}

/// In the middle of a corner, or from rest.
void LookAheadGenerator::begin(const SegmentDescriptor& next, double instant) noexcept {
  const PathLeg leg = *ring_.next_leg();
  const bool goes_on = on_run() && beyond_end();
  begin_ = leg.begin;
  end_ = leg.end;
  leg_ = leg;
  arrival_ = instant;
  run_ = goes_on || has_way(next);
  if (run_ && !goes_on) begin_run(leg);
  next.profile.present() ? begin_profile(next) : expect_events(next, instant);
  segment() = next;
}

void LookAheadGenerator::begin_profile(const SegmentDescriptor& next) noexcept {
  moved_ = true;
  clock_.jump();  // it begins at rest
  zero_ = clock_.path_time();
  profile_.begin(next, segment().target, segment().target, 0, true);
  profile_events_.begin(next, zero_, 0, true, zero_, clock_.override_share());
}

/// A mean of N samples is at rest N − 1 periods after the guide, but its last jerk comes after
/// that: it must not meet the next run's.
bool LookAheadGenerator::settled() const noexcept {
  const double mean = average_.periods() * period();
  const bool bounded = average_.periods() > 1 || guide_.pauses();
  return !bounded || history_.stands_since() + mean <= guide_time() + kSameInstant;
}

void LookAheadGenerator::begin_run(const PathLeg& leg) noexcept {
  if (moved_) guide_.restart(guide_.index(), segment().target);
  moved_ = false;
  guide_.begin_run(leg.begin, guide_time() + (settled() ? 0 : period()),
                   leg.pauses ? leg.average * period() : 0);
  average_.begin_run(leg.average, leg.of_sigma, guide_);
  history_.begin(guide_time(), leg.begin);
  events_.begin_run({guide_time(), leg.begin, 0});
}

void LookAheadGenerator::expect_events(const SegmentDescriptor& next, double instant) noexcept {
  for (const PathEvent& event : next.on_the_way)
    events_.expect(event, begin_ + std::clamp(event.share, 0.0, 1.0) * length(),
                   instant - skipped_);
}

void LookAheadGenerator::end_path() noexcept {
  if (on_run()) end_ = std::max(begin_, cursor());
  moved_ = true;
  run_ = false;
  events_.drop();
  profile_events_.drop();
}

void LookAheadGenerator::drop_path(std::uint32_t generation) noexcept {
  dropping_ = true;
  dropped_ = generation;
  ring_.ask_drop(generation);
}

/// The numbers of what was given up are passed over, unless they come again.
void LookAheadGenerator::finish_drop() noexcept {
  std::uint32_t last = segment().number;
  for (const PathLeg* leg = ring_.next_leg(); leg != nullptr; leg = ring_.next_leg()) {
    last = leg->segment.number;
    ring_.pop_leg();
  }
  last = std::max(last, ring_.last_number());
  if (dropped_ != 0 && last > segment().number) skip_to(last);
  released_ = ring_.skip_dropped();
  guide_.restart(released_, segment().target);
  dropping_ = false;
}

void LookAheadGenerator::sample_path(GeneratorSample& sample) const noexcept {
  PathPoint p = average_.mean();
  const double sigma = length() > 0 ? average_.sigma() - begin_ : 0;
  sample.sigma = leg_.way(sigma);
  sample.rate = average_.rate() * leg_.slope(sigma);
  const bool stopped_short = guide_.at_path_end() && !guide_.at_run_end();
  sample.limit = stopped_short ? limit_number::kEndOfBuffer : number_of(guide_.limit());
  if (profiled()) {
    sample.sigma = clock_.path_time() - zero_;
    sample.rate = clock_.rate();
    p = driven(profile_.sample(sample.sigma), clock_.rate(), clock_.slope());
    sample.limit = override_share() < 1 ? limit_number::kOverride : segment().limit;
  } else if (!on_run()) {
    p = {segment().target, p.qd * 0, p.qdd * 0};
    sample.rate = 0;
  }
  sample.reference.q = p.q;
  sample.reference.qd = p.qd;
  sample.reference.qdd = p.qdd;
}

double LookAheadGenerator::share_done() const noexcept {
  if (profiled()) return std::min((clock_.path_time() - zero_) / segment().duration, 1.0);
  const double way = leg_.way(length());
  return way > 0 ? std::clamp(leg_.way(cursor() - begin_) / way, 0.0, 1.0) : 1;
}

std::optional<double> LookAheadGenerator::stands_since() const noexcept {
  if (profiled()) {
    return clock_.held() ? std::optional(clock_.steady_since()) : std::nullopt;
  }
  if (!on_run()) return stamp();
  if (!guide_.stands() || !average_.stands()) return std::nullopt;
  return std::min(told(history_.stands_since()) + lag(), stamp());
}

/// The guide is ahead of the references, and may have passed decision points further on.
std::uint32_t LookAheadGenerator::decided() const noexcept {
  const std::uint32_t number = segment().number;
  if (profiled()) {
    const bool due = clock_.next() > zero_ + segment().duration + kSameInstant;
    return due ? number : number - 1;
  }
  const double next = guide_.sigma() + guide_.rate() * period();
  if (on_run() && next < leg_.decides - rounding(leg_.decides)) return number - 1;
  std::uint32_t decided = number;
  const PathLeg* leg = ring_.leg(0);
  for (std::size_t i = 0; leg != nullptr && !dropping_; leg = ring_.leg(++i)) {
    if (!on_run() || !has_way(leg->segment) || next < leg->decides) break;
    decided = leg->segment.number;
  }
  return decided;
}

const Effect* LookAheadGenerator::take_path_event(double until, std::uint32_t number,
                                                  double& due) noexcept {
  const double path_time = clock_.passed_by(until) + kSameInstant;
  if (const Effect* effect = profile_events_.take(path_time, number, due)) {
    due = clock_.run_time(due);
    tell_cut_lead(*effect, due, profile_events_.cut());
    return effect;
  }
  const PlaceEvents::Until passed{until - skipped_, number};
  const Effect* const effect = events_.take(passed, due);
  if (effect == nullptr) return nullptr;
  due += skipped_;
  tell_cut_lead(*effect, due, events_.cut());
  return effect;
}

}  // namespace rob::motion
