#include "motion/generate/segment_sequence.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/space/cycle_instant.h"

namespace rob::motion {

namespace {

using EventKind = MotionEvent::Kind;

constexpr std::uint32_t kAll = std::numeric_limits<std::uint32_t>::max();

}  // namespace

SegmentSequence::SegmentSequence(const RobotModel& robot, PathLaw& law, UnderWay& now,
                                 EffectOrder& effects, EarlyEnd& early, EventQueue& events)
    : period_(robot.reference_period),
      law_(law),
      now_(now),
      effects_(effects),
      early_(early),
      events_(events),
      dwell_(robot, now),
      jog_(robot) {
  const JointVector& start = now.segment.target;
  const JointVector zero = JointVector::Zero(start.size());
  sample_.reference = {0, start, zero, zero};
}

void SegmentSequence::go_on() noexcept {
  if (now_.jogging()) {
    run_jog();
  } else if (now_.running) {
    run_segments();
  }
  let_path_events_act(now_.stamp, kAll);
}

/// All that lies between the reference before and this one, in order of time. A motion takes its
/// time, and the buffer holds only so many dwells: the turns are few.
void SegmentSequence::run_segments() noexcept {
  pass_by();
  while (now_.running && next_end() < now_.stamp - kSameInstant) {
    leave(next_end());
    pass_by();
  }
  const bool at_rest = now_.running && (now_.segment.dwell || law_.ends_at_rest());
  if (at_rest && next_end() <= now_.stamp + kSameInstant) arrive(next_end());
}

void SegmentSequence::leave(double instant) noexcept {
  if (now_.segment.settle.present()) return begin_settling(instant);
  const bool rests = now_.segment.dwell || law_.ends_at_rest();
  rests ? follow_from_rest(instant) : decide(instant);
}

/// On the way, without a stop.
void SegmentSequence::decide(double instant) noexcept {
  const bool nothing_else = law_.closed();  // before looking: all that was pushed is then seen
  const SegmentDescriptor* const next = next_to_begin();
  if (next != nullptr && (next->from_rest || next->jog->present())) return law_.stop();
  if (next != nullptr && take_up(*next, instant)) return law_.pop_segment();
  if (!nothing_else) report_late_decision(instant);
  law_.stop();
}

void SegmentSequence::pass_by() noexcept {
  if (now_.on_path()) return pass_targets();
  const bool over = now_.dwelling() && dwell_.end() <= now_.stamp + kSameInstant;
  if (over && !effects_.passed(now_.segment.number)) pass(now_.segment.number, dwell_.end());
}

void SegmentSequence::pass_targets() noexcept {
  if (const auto target = law_.passed(effects_.passed())) pass(target->number, target->instant);
  for (auto left = law_.ran_on(); left; left = law_.ran_on()) {
    if (!effects_.passed(now_.segment.number)) pass(now_.segment.number, *left);
    if (!take_up(*law_.next_segment(), *left)) return;
    law_.pop_segment();
  }
}

/// Effects up to this number are due, after the events on the way of their motions.
void SegmentSequence::pass(std::uint32_t number, double instant) noexcept {
  let_path_events_act(instant, number);
  effects_.pass(number);
  events_.reach(instant);
  let_effects_act(events_.latest());
}

/// The segment that follows at this very instant is not decided before the next reference; here it
/// only matters whether one can.
void SegmentSequence::arrive(double instant) noexcept {
  if (now_.segment.settle.present()) return begin_settling(instant);
  events_.reach(instant);
  early_.close_guard(law_.next_segment(), instant);
  const bool nothing_else = law_.closed();  // before looking: all that came before is then seen
  if (nothing_else && law_.next_segment() == nullptr) now_.running = false;
}

/// Null: nothing may begin now.
const SegmentDescriptor* SegmentSequence::next_to_begin() const noexcept {
  const SegmentDescriptor* const next = events_.faulted() ? nullptr : law_.next_segment();
  return next != nullptr && law_.fits(*next) ? next : nullptr;
}

/// The axes stand at the end of the segment, and may go on at `instant`.
void SegmentSequence::follow_from_rest(double instant) noexcept {
  early_.close_guard(law_.next_segment(), instant);
  const SegmentDescriptor* const next = next_to_begin();
  if (next == nullptr || law_.begins_at_stamp(*next)) {
    now_.running = false;
  } else if (early_.hit_at_start(*next, instant) || take_up(*next, instant)) {
    law_.pop_segment();
  } else {
    now_.running = false;
  }
}

/// Begins `next` and says so; false, with a fault, if its rates would not be finite. The lowest
/// axis is reported.
bool SegmentSequence::take_up(const SegmentDescriptor& next, double instant) noexcept {
  const JointVector& from = now_.segment.target;
  const bool timed = std::isfinite(next.duration) && std::isfinite(next.t_acc);
  for (int i = 0; i < from.size(); ++i) {
    const double duration = next.no_length ? 1 : next.duration;  // a stop has no rate
    const double rate = (next.target[i] - from[i]) / duration;
    if (timed && std::isfinite(rate) && std::isfinite(next.target[i])) continue;
    fail(next, i, instant);
    return false;
  }
  next.dwell ? begin_dwell(next, instant) : law_.begin(next, instant);
  report_start(instant, next.no_length ? 0 : 1);
  return true;
}

/// `way`: 1 if it has a way to go.
void SegmentSequence::report_start(double instant, double way) noexcept {
  now_.running = true;
  events_.report({.kind = EventKind::SegmentStarted,
                  .time = instant,
                  .tag = now_.segment.tag,
                  .number = now_.segment.number,
                  .value = way});
}

/// The axes stand already: what comes before a dwell is exact.
void SegmentSequence::begin_dwell(const SegmentDescriptor& segment, double instant) noexcept {
  now_.segment = segment;
  dwell_.begin(instant, segment.duration);
  if (now_.segment.settle.present()) begin_settling(instant);
}

/// The reference has come to rest at `instant`, and stays there until look_at_position() ends it.
void SegmentSequence::begin_settling(double instant) noexcept {
  events_.reach(instant);
  now_.segment.no_length = now_.segment.dwell = true;
  now_.segment.profile = {};
  now_.segment.duration = 0;
  dwell_.settle(instant);
}

void SegmentSequence::look_at_position() noexcept {
  if (!dwell_.settling()) return;
  const auto off = dwell_.off();
  if (!off) {
    now_.segment.settle = {};
    dwell_.begin(now_.stamp, 0);
    return pass(now_.segment.number, now_.stamp);
  }
  if (!dwell_.late()) return;
  events_.report_fault({.kind = EventKind::Unsettled,
                        .time = now_.stamp,
                        .tag = now_.segment.tag,
                        .number = now_.segment.number,
                        .off = *off});
}

/// Whether it stands after what is not in position yet: what settles now, or will once the motion
/// under way has been made exact.
bool SegmentSequence::awaits_position(const Effect& effect) const noexcept {
  if (now_.segment.settle.present()) return true;
  const SegmentDescriptor* const next = law_.next_segment();
  const bool stop = next != nullptr && next->no_length && !next->dwell;
  return stop && next->settle.present() && effect.after >= now_.segment.number;
}

void SegmentSequence::let_effects_act(double time) noexcept {
  effects_.act(time, [this](const Effect& effect) noexcept {
    return early_.failing() || awaits_position(effect);
  });
}

void SegmentSequence::let_path_events_act(double until, std::uint32_t number) noexcept {
  constexpr double kInstant = 1e-6;  // s, to which a report gives times
  if (early_.failing()) return;
  for (auto event = law_.take_path_event(until, number); event.effect != nullptr;
       event = law_.take_path_event(until, number)) {
    const Tag tag = event.effect->tag;
    if (event.cut > kInstant)
      events_.report(
          {.kind = EventKind::LeadCut, .time = event.due, .tag = tag, .value = event.cut});
    events_.report(
        {.kind = EventKind::ActionDue, .time = event.due, .tag = tag, .effect = *event.effect});
  }
}

void SegmentSequence::start_from_rest() noexcept {
  if (now_.running) return;
  const SegmentDescriptor* const next = next_to_begin();
  if (next == nullptr) return;
  finished_ = false;
  if (early_.braking()) return;
  if (early_.hit_at_start(*next, now_.stamp)) return law_.pop_segment();
  if ((next->jog->present() || next->profile.present()) && !law_.settled()) return;
  if (next->jog->present()) return begin_jog(*next, now_.stamp);
  if (!take_up(*next, now_.stamp)) return;
  law_.pop_segment();
  while (now_.dwelling() && !dwell_.settling() && now_.segment.duration == 0) {
    pass_by();
    follow_from_rest(dwell_.end());
  }
}

double SegmentSequence::jog_share() const noexcept {
  return now_.orders.stop ? 0 : std::min(now_.orders.share, 1.0);
}

/// The axes stand, or are those of a jog that it joins. Its first period follows `instant`.
void SegmentSequence::begin_jog(const SegmentDescriptor& segment, double instant) noexcept {
  const std::uint32_t before = now_.segment.number;
  const JointVector from = now_.segment.target;
  now_.jogging() ? jog_.join(*segment.jog) : jog_.begin(*segment.jog, from);
  now_.segment = segment;
  now_.segment.target = from;
  effects_.pass(before);
  report_start(instant, 1);
  law_.pop_segment();
}

void SegmentSequence::run_jog() noexcept {
  join_jog();
  if (jog_.step(jog_.over() ? 0 : jog_share())) {
    const int axis = jog_.body() ? MotionEvent::kAtBody : jog_.axis_at_end();
    const double place = axis < 0 ? 0 : jog_.place()[axis];
    events_.report({.kind = EventKind::JogStopped,
                    .time = now_.stamp,
                    .tag = now_.segment.tag,
                    .number = now_.segment.number,
                    .value = static_cast<double>(jog_.body().value_or(0)) + place,
                    .axis = axis});
  }
  if (jog_.over() && jog_.stands() && !early_.braking()) end_jog();
}

void SegmentSequence::join_jog() noexcept {
  const SegmentDescriptor* const next = events_.faulted() ? nullptr : law_.next_segment();
  const bool may = jog_share() > 0 && !now_.segment.guard.present();
  if (!may || next == nullptr || !next->jog->present() || !jog_.joins(*next->jog)) return;
  const double instant = now_.stamp - period_;
  begin_jog(*next, instant);
  let_effects_act(instant);
}

/// At rest, and nothing has joined it.
void SegmentSequence::end_jog() noexcept {
  events_.reach(now_.stamp);
  stand_at(jog_.place());
  effects_.pass(now_.segment.number);
  Rest rest = now_.rest(Rest::Outcome::Reached, nullptr, events_.latest());
  rest.q = now_.segment.target;
  events_.report(rest, events_.latest(), now_.segment.number);
}

void SegmentSequence::finish_if_done() noexcept {
  if (now_.running || finished_ || events_.faulted() || !law_.closed()) return;
  if (law_.next_segment() != nullptr || effects_.pending()) return;
  if (law_.awaits_path_event()) return;  // a LAG is not over yet
  finished_ = true;
  events_.report({.kind = EventKind::Finished,
                  .time = events_.latest(),
                  .tag = now_.segment.tag,
                  .number = now_.segment.number});
}

void SegmentSequence::skip(double gap) noexcept {
  law_.skip(gap);
  dwell_.skip(gap);
}

void SegmentSequence::skip_to(std::uint32_t number) noexcept {
  now_.segment.number = number;
  effects_.pass(number);
}

void SegmentSequence::drop_ended() noexcept {
  for (const SegmentDescriptor* next = law_.next_segment();
       next != nullptr && effects_.has_ended(next->generation); next = law_.next_segment()) {
    skip_to(next->number);
    law_.pop_segment();
  }
}

void SegmentSequence::make_sample() noexcept {
  sample_.reference.time = now_.stamp;
  if (now_.jogging()) {
    jog_.sample(jog_share(), now_.orders.share < 1, sample_);
  } else if (now_.on_path()) {
    follow_path();
  }
  if (!now_.running || now_.segment.dwell) stand();
  sample_.tag = now_.segment.tag;
  sample_.piece = now_.segment.number;
}

void SegmentSequence::follow_path() noexcept {
  GeneratorSample next = sample_;
  law_.sample_path(next);
  const JointReference& r = next.reference;
  for (int i = 0; i < r.q.size(); ++i) {
    if (std::isfinite(r.q[i]) && std::isfinite(r.qd[i]) && std::isfinite(r.qdd[i])) continue;
    // No descriptor that the planner makes comes here. The last reference is held.
    fail(now_.segment, i, now_.stamp);
    now_.segment.target = sample_.reference.q;
    now_.running = false;
    return;
  }
  sample_ = next;
}

void SegmentSequence::stand() noexcept {
  const bool dwells = now_.dwelling();
  sample_.reference.q = now_.segment.target;
  sample_.reference.qd.setZero();
  sample_.reference.qdd.setZero();
  sample_.sigma = dwells ? dwell_.done() : law_.sigma_at_rest();
  sample_.rate = dwells && !now_.orders.stop ? 1 : 0;
  sample_.limit = 0;
}

void SegmentSequence::stand_at(const JointVector& q) noexcept {
  law_.end_path();
  now_.running = false;
  now_.segment.target = q;
  now_.segment.guard = {};
  now_.segment.settle = {};
  stand();
}

JointVector SegmentSequence::standing_place() const noexcept {
  if (now_.jogging()) return jog_.place();
  if (!now_.on_path()) return now_.segment.target;
  GeneratorSample here = sample_;
  law_.sample_path(here);
  return here.reference.q;
}

std::optional<double> SegmentSequence::at_rest_since() const noexcept {
  if (!jog_.stands()) return std::nullopt;
  if (now_.jogging()) return now_.stamp;
  return now_.on_path() ? law_.stands_since() : now_.stamp_before;
}

double SegmentSequence::share_done() const noexcept {
  if (now_.dwelling() && now_.segment.duration > 0) return dwell_.done() / now_.segment.duration;
  return now_.on_path() ? law_.share_done() : 1;
}

std::uint32_t SegmentSequence::decided() const noexcept {
  const std::uint32_t number = now_.segment.number;
  if (now_.on_path()) return law_.decided();
  if (now_.jogging()) return jog_.over() ? number : number - 1;
  const bool goes_on = now_.stamp + period_ <= dwell_.end() + kSameInstant;
  return now_.dwelling() && (now_.orders.stop || goes_on) ? number - 1 : number;
}

void SegmentSequence::report_late_decision(double instant) noexcept {
  if (events_.faulted()) return;
  late_decisions_.fetch_add(1, std::memory_order_relaxed);
  events_.report({.kind = EventKind::LateDecision,
                  .time = instant,
                  .tag = now_.segment.tag,
                  .number = now_.segment.number});
}

void SegmentSequence::fail(const SegmentDescriptor& segment, int axis, double instant) noexcept {
  events_.report_fault({.kind = EventKind::Fault,
                        .time = instant,
                        .tag = segment.tag,
                        .number = segment.number,
                        .axis = axis});
}

}  // namespace rob::motion
