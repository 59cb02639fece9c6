#include "motion/generate/segment_generator.h"

#include <cmath>
#include <limits>

#include "motion/space/cycle_instant.h"

namespace rob::motion {

namespace {

using EventKind = MotionEvent::Kind;

/// [choice: four times what the buffer's effects can make in one period; taken every period]
constexpr std::size_t kEvents = 4 * LookAheadBuffer::kEffects;

/// Each is a barrier for the program; two may follow each other within one period.
constexpr std::size_t kRests = 8;

/// Missed periods that are made up: 20, or 200 ms where that is more.
std::int64_t most_missed(double period) {
  return std::max<std::int64_t>(20, std::llround(0.2 / period));
}

}  // namespace

SegmentGenerator::SegmentGenerator(const RobotModel& robot, LookAheadBuffer& buffer,
                                   const JointVector& start)
    : robot_(robot),
      period_(robot.reference_period),
      most_missed_(most_missed(robot.reference_period)),
      buffer_(buffer),
      events_(kEvents),
      rests_(kRests),
      stamp_(-robot.reference_period),
      jog_(robot) {
  segment_.target = start;
  const JointVector zero = JointVector::Zero(start.size());
  sample_.reference = {0, start, zero, zero};
  view_.reference = view_.measured = measured_before_ = start;
  rest_.q = rest_.trip_q = start;
}

const GeneratorSample& SegmentGenerator::advance(std::int64_t period) noexcept {
  catch_up(period);
  while (last_period_ < period) step(cycle_instant(++last_period_, period_));
  return sample_;
}

/// A delay that is too long to be made up is taken out of the path's time.
void SegmentGenerator::catch_up(std::int64_t period) noexcept {
  const std::int64_t missed = period - last_period_ - 1;
  if (missed <= most_missed_) return;
  const double lateness = static_cast<double>(missed) * period_;
  skip(lateness);
  dwell_end_ += lateness;
  settle_by_ += lateness;
  hold();
  last_period_ = period - 1;
  stamp_ = cycle_instant(last_period_, period_);
  tell({.kind = EventKind::Overrun,
        .time = stamp_,
        .tag = segment_.tag,
        .number = segment_.number,
        .value = lateness});
}

void SegmentGenerator::set_override(double share) noexcept {
  if (share > 0) override_ = share;
}

void SegmentGenerator::step(double stamp) noexcept {
  if (dwelling() && stopping()) {
    dwell_end_ += stamp - stamp_;
    settle_by_ += stamp - stamp_;
  }
  stamp_ = stamp;
  go_on_to_stamp();
  if (jogging()) {
    run_jog();
  } else if (running_) {
    run_segments();
  }
  fire_path_events(stamp, std::numeric_limits<std::uint32_t>::max());
  if (const auto since = at_rest_since(); braking_ && since) end_early(*since);
  report_held();
  report_handled();
  drop_ended();
  fire_effects(stamp);
  if (!running_) start_from_rest();
  finish_if_done();
  make_sample();
  publish_decidable();
}

/// All that lies between the reference before and this one, in order of time. A motion takes its
/// time, and the buffer holds only so many dwells: the turns are few.
void SegmentGenerator::run_segments() noexcept {
  pass_by();
  while (running_ && next_end() < stamp_ - kSameInstant) {
    leave(next_end());
    pass_by();
  }
  const bool at_rest = running_ && (segment_.dwell || ends_at_rest());
  if (at_rest && next_end() <= stamp_ + kSameInstant) arrive(next_end());
}

void SegmentGenerator::leave(double instant) noexcept {
  if (segment_.settle.present()) return begin_settling(instant);
  segment_.dwell ? follow_from_rest(instant) : decide(instant);
}

void SegmentGenerator::pass_by() noexcept {
  if (on_path()) return pass_targets();
  const bool over = dwelling() && dwell_end_ <= stamp_ + kSameInstant;
  if (over && !passed(segment_.number)) pass(segment_.number, dwell_end_);
}

void SegmentGenerator::pass(std::uint32_t number, double instant) noexcept {
  fire_path_events(instant, number);
  passed_ = number;
  latest_ = std::max(latest_, instant);
  fire_effects(latest_);
}

/// What follows at this very instant is not decided before the next reference; here it only matters
/// whether anything can.
void SegmentGenerator::arrive(double instant) noexcept {
  if (segment_.settle.present()) return begin_settling(instant);
  latest_ = std::max(latest_, instant);
  close_guard(instant);
  const bool nothing_else = closed();  // before looking: all that came before is then seen
  if (nothing_else && next_segment() == nullptr) running_ = false;
}

const SegmentDescriptor* SegmentGenerator::next_to_begin() const noexcept {
  const SegmentDescriptor* const next = faulted_ ? nullptr : next_segment();
  return next != nullptr && fits(*next) ? next : nullptr;
}

void SegmentGenerator::follow_from_rest(double instant) noexcept {
  close_guard(instant);
  const SegmentDescriptor* const next = next_to_begin();
  if (next == nullptr || begins_at_stamp(*next)) {
    running_ = false;
  } else if (hit_at_start(*next, instant) || take_up(*next, instant)) {
    pop_segment();
  } else {
    running_ = false;
  }
}

/// The lowest axis is told.
bool SegmentGenerator::take_up(const SegmentDescriptor& next, double instant) noexcept {
  const bool timed = std::isfinite(next.duration) && std::isfinite(next.t_acc);
  for (int i = 0; i < segment_.target.size(); ++i) {
    const double duration = next.no_length ? 1 : next.duration;  // a stop has no rate
    const double rate = (next.target[i] - segment_.target[i]) / duration;
    if (timed && std::isfinite(rate) && std::isfinite(next.target[i])) continue;
    fail(next, i, instant);
    return false;
  }
  next.dwell ? begin_dwell(next, instant) : begin(next, instant);
  running_ = true;
  tell({.kind = EventKind::SegmentStarted,
        .time = instant,
        .tag = next.tag,
        .number = next.number,
        .value = next.no_length ? 0.0 : 1.0});
  return true;
}

/// The axes stand already: what comes before a dwell is exact.
void SegmentGenerator::begin_dwell(const SegmentDescriptor& segment, double instant) noexcept {
  segment_ = segment;
  dwell_end_ = instant + segment.duration;
  if (segment_.settle.present()) begin_settling(instant);
}

double SegmentGenerator::dwell_done() const noexcept {
  if (settling()) return segment_.settle.time - (settle_by_ - stamp_);
  return segment_.duration - (dwell_end_ - stamp_);
}

void SegmentGenerator::fail(const SegmentDescriptor& segment, int axis, double instant) noexcept {
  faulted_ = true;
  tell({.kind = EventKind::Fault,
        .time = instant,
        .tag = segment.tag,
        .number = segment.number,
        .axis = axis});
}

void SegmentGenerator::start_from_rest() noexcept {
  if (holding()) return;
  const SegmentDescriptor* const next = next_to_begin();
  if (next == nullptr) return;
  finished_ = false;
  if (braking_) return;
  if (hit_at_start(*next, stamp_)) return pop_segment();
  if ((next->jog->present() || next->profile.present()) && !settled()) return;
  if (next->jog->present()) return begin_jog(*next, stamp_);
  if (!take_up(*next, stamp_)) return;
  pop_segment();
  while (dwelling() && !settling() && segment_.duration == 0) {
    pass_by();
    follow_from_rest(dwell_end_);
  }
}

void SegmentGenerator::finish_if_done() noexcept {
  if (running_ || finished_ || faulted_ || !closed()) return;
  if (next_segment() != nullptr || buffer_.next_effect() != nullptr) return;
  if (awaits_path_event()) return;  // a LAG is not over yet
  finished_ = true;
  tell({.kind = EventKind::Finished,
        .time = latest_,
        .tag = segment_.tag,
        .number = segment_.number});
}

std::optional<double> SegmentGenerator::at_rest_since() const noexcept {
  if (!jog_.stands()) return std::nullopt;
  if (jogging()) return stamp_;
  return on_path() ? stands_since() : cycle_instant(last_period_ - 1, period_);
}

void SegmentGenerator::report_held() noexcept {
  const bool held = axes_held();
  const bool asked = stopped_ || !handling() || faulted_;
  if (!(held || (faulted_ && !running_)) || held_told_ || !asked) return;
  held_told_ = true;
  tell({.kind = EventKind::Held,
        .time = held ? *at_rest_since() : latest_,
        .tag = segment_.tag,
        .number = segment_.number,
        .value = share_of_time()});
}

double SegmentGenerator::share_of_time() const noexcept {
  if (dwelling() && segment_.duration > 0) return dwell_done() / segment_.duration;
  return on_path() ? share_done() : 1;
}

/// Effects that are due, in their order. With the event ring full they wait in the buffer.
void SegmentGenerator::fire_effects(double time) noexcept {
  for (const Effect* effect = buffer_.next_effect(); effect != nullptr && !events_.full();
       effect = buffer_.next_effect()) {
    const bool dropped = effect->generation <= ended_ && effect->after > kept_;
    const bool waits = effect->after > passed_ || failing() || awaits_position(*effect);
    if (!dropped && waits) return;
    arm_or_disarm(*effect, dropped);
    tell({.kind = dropped ? EventKind::EffectDropped : EventKind::EffectDue,
          .time = time,
          .tag = effect->tag,
          .effect = *effect});
    buffer_.pop_effect();
  }
}

void SegmentGenerator::fire_path_events(double until, std::uint32_t number) noexcept {
  double due = 0;
  if (failing()) return;
  while (const Effect* effect = take_path_event(until, number, due)) {
    tell({.kind = EventKind::ActionDue, .time = due, .tag = effect->tag, .effect = *effect});
  }
}

void SegmentGenerator::make_sample() noexcept {
  sample_.reference.time = stamp_;
  if (jogging()) {
    follow_jog();
  } else if (on_path()) {
    follow_path();
  }
  if (!running_ || segment_.dwell) stand();
  sample_.tag = segment_.tag;
  sample_.piece = segment_.number;
  sample_.state = state();
}

MotionState SegmentGenerator::state() const noexcept {
  if (axes_held() || (faulted_ && !running_)) return MotionState::Held;
  if (!running_) return untold_ ? MotionState::Stopping : MotionState::Idle;
  if (stopping()) return MotionState::Stopping;
  return jogging() ? MotionState::Jogging : MotionState::Running;
}

void SegmentGenerator::follow_path() noexcept {
  GeneratorSample next = sample_;
  sample_path(next);
  const JointReference& r = next.reference;
  for (int i = 0; i < r.q.size(); ++i) {
    if (std::isfinite(r.q[i]) && std::isfinite(r.qd[i]) && std::isfinite(r.qdd[i])) continue;
    // No descriptor that the planner makes comes here. The last reference is held.
    fail(segment_, i, stamp_);
    segment_.target = sample_.reference.q;
    running_ = false;
    return;
  }
  sample_ = next;
}

void SegmentGenerator::stand() noexcept {
  sample_.reference.q = segment_.target;
  sample_.reference.qd.setZero();
  sample_.reference.qdd.setZero();
  sample_.sigma = dwelling() ? dwell_done() : sigma_at_rest();
  sample_.rate = dwelling() && !stopping() ? 1 : 0;
  sample_.limit = 0;
}

/// While an error ends all that was commanded there is nothing to decide: the program learns of it
/// first.
void SegmentGenerator::publish_decidable() noexcept {
  if (failing() || untold_) return;
  std::uint32_t number = segment_.number;
  if (on_path()) {
    number = decided();
  } else if (jogging() && !jog_is_over()) {
    --number;
  } else if (dwelling() && (stopping() || stamp_ + period_ <= dwell_end_ + kSameInstant)) {
    --number;
  }
  for (std::uint32_t next = decidable() + 1; tells_decisions() && next <= number; ++next)
    tell({.kind = EventKind::DecisionPoint, .time = stamp_, .tag = segment_.tag, .number = next});
  if (number > decidable()) decidable_.store(number, std::memory_order_release);
}

void SegmentGenerator::tell_late_decision(double instant) noexcept {
  if (faulted_) return;
  late_decisions_.fetch_add(1, std::memory_order_relaxed);
  tell({.kind = EventKind::LateDecision,
        .time = instant,
        .tag = segment_.tag,
        .number = segment_.number});
}

void SegmentGenerator::tell_cut_lead(const Effect& effect, double due, double by) noexcept {
  constexpr double kInstant = 1e-6;  // s, to which a report tells times
  if (by <= kInstant) return;
  tell({.kind = EventKind::LeadCut, .time = due, .tag = effect.tag, .value = by});
}

double SegmentGenerator::live_rate(const SegmentDescriptor& segment) noexcept {
  const double rate = faulted_ ? 0 : segment.live.rate(view_);
  if (std::isfinite(rate)) return rate;
  faulted_ = true;
  tell({.kind = MotionEvent::Kind::PaceFailed,
        .time = stamp_,
        .tag = segment.tag,
        .number = segment.number});
  return 0;
}

void SegmentGenerator::tell(MotionEvent event) noexcept {
  event.time = latest_ = std::max(latest_, event.time);
  events_.push(event);
}

}  // namespace rob::motion
