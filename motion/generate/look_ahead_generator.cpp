#include "motion/generate/look_ahead_generator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "motion/ahead/path_item.h"
#include "motion/generate/limit_numbers.h"

namespace rob::motion {

namespace {

/// [choice] jogs and profiles are slowed by it, the path follows it up to here
constexpr double kMostShare = 2;

constexpr double kAnyPace = std::numeric_limits<double>::infinity();

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

LookAheadLaw::LookAheadLaw(const RobotModel& robot, PathRing& ring, UnderWay& now,
                           EventQueue& events)
    : PathLaw(now, events),
      period_(robot.reference_period),
      ring_(ring),
      guide_(ring, now.segment.target),
      average_(ring, now.segment.target),
      events_on_way_(guide_, average_, robot.reference_period),
      clock_(time_scale_limits(robot), robot.reference_period) {
  guide_.brake();
}

void LookAheadLaw::take_share() noexcept {
  clock_.set_override(now_.orders.share);
  ring_.share.store(std::min(now_.orders.share, kMostShare), std::memory_order_relaxed);
}

const SegmentDescriptor* LookAheadLaw::next_segment() const noexcept {
  const PathLeg* const leg = dropping_ ? nullptr : ring_.next_leg();
  return leg == nullptr ? nullptr : &leg->segment;
}

bool LookAheadLaw::begins_at_stamp(const SegmentDescriptor& next) const noexcept {
  return has_way(next) || next.jog->present() || next.profile.present();
}

void LookAheadLaw::skip(double gap) noexcept {
  skipped_ += gap;
  clock_.skip(gap);
}

PathLaw::News LookAheadLaw::go_on_to_stamp() noexcept {
  News news;
  if (dropping_ && ring_.drop_done()) news.skipped = finish_drop();
  now_.orders.stop ? clock_.hold() : clock_.resume();
  clock_.advance(now_.stamp, !(now_.on_path() && profiled()));
  step_guide();
  const std::uint32_t late = ring_.late.load(std::memory_order_relaxed);
  news.late_decisions = late - std::exchange(late_, late);
  return news;
}

/// Where no path is followed it stands, and its time goes on.
void LookAheadLaw::step_guide() noexcept {
  const bool runs = on_run();
  const double pace = runs ? live_pace() : kAnyPace;
  runs && !now_.orders.stop && pace > 0 ? guide_.release() : guide_.brake();
  guide_.set_share(std::min(now_.orders.share, kMostShare));
  guide_.set_pace(pace);
  guide_.step(guide_time(), [this](const Guide::Part& part) noexcept { history_.keep(part); });
  ring_.sigma.store(guide_.sigma(), std::memory_order_relaxed);
  ring_.rate.store(guide_.rate(), std::memory_order_relaxed);
  ring_.periods.fetch_add(1, std::memory_order_relaxed);
  if (!runs) return events_on_way_.stand(guide_time());
  average_.take(guide_);
  events_on_way_.go_on({guide_time(), average_.sigma(), average_.rate()});
  report_missed_leads();
  history_.forget(guide_time() - lag() - period_);  // what was passed in this period is kept
  released_ = std::max(released_, average_.oldest());
  ring_.release(released_);
}

/// σ' that the motion on which the guide is, ahead of the references, may have.
double LookAheadLaw::live_pace() noexcept {
  const SegmentDescriptor* const leg = guide_.sigma() < end_ ? &now_.segment : next_segment();
  const bool paced = leg != nullptr && leg->live.present();  // of no length there is no share
  return paced ? live_rate(*leg) * leg->ahead.length : kAnyPace;
}

void LookAheadLaw::report_missed_leads() noexcept {
  while (const auto missed = events_on_way_.take_missed(period_)) {
    events_.report({.kind = MotionEvent::Kind::LeadMissed,
                    .time = missed->time + skipped_,
                    .tag = missed->tag,
                    .value = missed->error});
  }
}

bool LookAheadLaw::beyond_end() const noexcept { return cursor() > end_ + rounding(end_); }

std::optional<PathLaw::Passed> LookAheadLaw::passed(std::uint32_t known) const noexcept {
  const std::uint32_t number = now_.segment.number;
  if (known >= number) return std::nullopt;
  const double arrived = end();
  return arrived <= now_.stamp + kSameInstant ? std::optional(Passed{number, arrived})
                                              : std::nullopt;
}

std::optional<double> LookAheadLaw::ran_on() const noexcept {
  const bool on = on_run() && beyond_end() && ring_.next_leg() != nullptr;
  return on ? passed_end() : std::nullopt;
}

/// When the references passed the end of the motion. Without a mean they are the guide, whose
/// instants are exact; else their σ is known at each stamp.
std::optional<double> LookAheadLaw::passed_end() const noexcept {
  if (average_.periods() > 1) return events_on_way_.passing(end_) + skipped_;
  const auto when = history_.when(end_, guide_time());
  return when ? std::optional(*when + skipped_) : std::nullopt;
}

/// The arrival of a run: when the references came to rest at its end.
double LookAheadLaw::arrival() const noexcept {
  const bool there = guide_.at_run_end() && average_.stands() && !beyond_end();
  if (!there) return std::numeric_limits<double>::infinity();
  return std::min(told(history_.stands_since()) + lag(), now_.stamp);
}

double LookAheadLaw::end() const noexcept {
  if (on_run()) return arrival();
  if (!profiled()) return arrival_;
  const double end = zero_ + now_.segment.duration;
  const bool comes = clock_.path_time() >= end - kSameInstant;
  return comes ? clock_.run_time(end) : std::numeric_limits<double>::infinity();
}

/// In the middle of a corner, or from rest.
void LookAheadLaw::begin(const SegmentDescriptor& next, double instant) noexcept {
  const PathLeg leg = *ring_.next_leg();
  const bool goes_on = on_run() && beyond_end();
  begin_ = leg.begin;
  end_ = leg.end;
  leg_ = leg;
  arrival_ = instant;
  run_ = goes_on || has_way(next);
  if (run_ && !goes_on) begin_run(leg);
  next.profile.present() ? begin_profile(next) : expect_events(next, instant);
  now_.segment = next;
}

void LookAheadLaw::begin_profile(const SegmentDescriptor& next) noexcept {
  moved_ = true;
  clock_.jump();  // it begins at rest
  zero_ = clock_.path_time();
  profile_.begin(next, now_.segment.target, now_.segment.target, 0, true);
  profile_events_.begin(next, zero_, 0, true, zero_, clock_.override_share());
}

/// A mean of N samples is at rest N − 1 periods after the guide, but its last jerk comes after
/// that: it must not meet the next run's.
bool LookAheadLaw::settled() const noexcept {
  const double mean = average_.periods() * period_;
  const bool bounded = average_.periods() > 1 || guide_.pauses();
  return !bounded || history_.stands_since() + mean <= guide_time() + kSameInstant;
}

void LookAheadLaw::begin_run(const PathLeg& leg) noexcept {
  if (moved_) guide_.restart(guide_.index(), now_.segment.target);
  moved_ = false;
  guide_.begin_run(leg.begin, guide_time() + (settled() ? 0 : period_),
                   leg.pauses ? leg.average * period_ : 0);
  average_.begin_run(leg.average, leg.of_sigma, guide_);
  history_.begin(guide_time(), leg.begin);
  events_on_way_.begin_run({guide_time(), leg.begin, 0});
}

void LookAheadLaw::expect_events(const SegmentDescriptor& next, double instant) noexcept {
  for (const PathEvent& event : next.on_the_way)
    events_on_way_.expect(event, begin_ + std::clamp(event.share, 0.0, 1.0) * length(),
                          instant - skipped_);
}

void LookAheadLaw::end_path() noexcept {
  if (on_run()) end_ = std::max(begin_, cursor());
  moved_ = true;
  run_ = false;
  events_on_way_.drop();
  profile_events_.drop();
}

void LookAheadLaw::drop_path(std::uint32_t generation) noexcept {
  dropping_ = true;
  dropped_ = generation;
  ring_.ask_drop(generation);
}

/// The numbers of what was given up are passed over, unless they come again: up to this one.
std::uint32_t LookAheadLaw::finish_drop() noexcept {
  std::uint32_t last = now_.segment.number;
  for (const PathLeg* leg = ring_.next_leg(); leg != nullptr; leg = ring_.next_leg()) {
    last = leg->segment.number;
    ring_.pop_leg();
  }
  last = std::max(last, ring_.last_number());
  released_ = ring_.skip_dropped();
  guide_.restart(released_, now_.segment.target);
  dropping_ = false;
  return dropped_ != 0 && last > now_.segment.number ? last : 0;
}

void LookAheadLaw::sample_path(GeneratorSample& sample) const noexcept {
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
    sample.limit = now_.orders.share < 1 ? limit_number::kOverride : now_.segment.limit;
  } else if (!on_run()) {
    p = {now_.segment.target, p.qd * 0, p.qdd * 0};
    sample.rate = 0;
  }
  sample.reference.q = p.q;
  sample.reference.qd = p.qd;
  sample.reference.qdd = p.qdd;
}

double LookAheadLaw::share_done() const noexcept {
  if (profiled()) return std::min((clock_.path_time() - zero_) / now_.segment.duration, 1.0);
  const double way = leg_.way(length());
  return way > 0 ? std::clamp(leg_.way(cursor() - begin_) / way, 0.0, 1.0) : 1;
}

std::optional<double> LookAheadLaw::stands_since() const noexcept {
  if (profiled()) {
    return clock_.held() ? std::optional(clock_.steady_since()) : std::nullopt;
  }
  if (!on_run()) return now_.stamp;
  if (!guide_.stands() || !average_.stands()) return std::nullopt;
  return std::min(told(history_.stands_since()) + lag(), now_.stamp);
}

/// The guide is ahead of the references, and may have passed decision points further on.
std::uint32_t LookAheadLaw::decided() const noexcept {
  const std::uint32_t number = now_.segment.number;
  if (profiled()) {
    const bool due = clock_.next() > zero_ + now_.segment.duration + kSameInstant;
    return due ? number : number - 1;
  }
  const double next = guide_.sigma() + guide_.rate() * period_;
  if (on_run() && next < leg_.decides - rounding(leg_.decides)) return number - 1;
  std::uint32_t decided = number;
  const PathLeg* leg = ring_.leg(0);
  for (std::size_t i = 0; leg != nullptr && !dropping_; leg = ring_.leg(++i)) {
    if (!on_run() || !has_way(leg->segment) || next < leg->decides) break;
    decided = leg->segment.number;
  }
  return decided;
}

PathLaw::DueEvent LookAheadLaw::take_path_event(double until, std::uint32_t number) noexcept {
  const double path_time = clock_.passed_by(until) + kSameInstant;
  double due = 0;
  if (const Effect* effect = profile_events_.take(path_time, number, due))
    return {effect, clock_.run_time(due), profile_events_.cut()};
  const PlaceEvents::Until passed{until - skipped_, number};
  const Effect* const effect = events_on_way_.take(passed, due);
  if (effect == nullptr) return {};
  return {effect, due + skipped_, events_on_way_.cut()};
}

}  // namespace rob::motion
