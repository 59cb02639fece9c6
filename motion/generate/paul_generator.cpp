#include "motion/generate/paul_generator.h"

#include <algorithm>
#include <cmath>

#include "motion/space/cycle_instant.h"

namespace rob::motion {

namespace {

using Kind = MotionEvent::Kind;

/// s. Instants that differ by less are one: rounding of sums of times, days long.
constexpr double kSameInstant = 1e-9;

/// [choice: four times what the buffer's effects can make in one period; taken every period]
constexpr std::size_t kEvents = 4 * LookAheadBuffer::kEffects;

/// Each is a barrier for the program; two may follow each other within one period.
constexpr std::size_t kRests = 8;

constexpr std::uint8_t kLimitEndOfBuffer = 20;
constexpr std::uint8_t kLimitOverride = 21;

/// Missed periods that are made up: 20, or 200 ms where that is more.
std::int64_t most_missed(double period) {
  return std::max<std::int64_t>(20, std::llround(0.2 / period));
}

}  // namespace

PaulGenerator::PaulGenerator(const RobotModel& robot, LookAheadBuffer& buffer,
                             const JointVector& start)
    : period_(robot.reference_period),
      most_missed_(most_missed(robot.reference_period)),
      reserve_(axis_reserve(robot)),
      buffer_(buffer),
      clock_(time_scale_limits(robot), robot.reference_period),
      events_(kEvents),
      rests_(kRests),
      tightest_(robot.t_acc),
      t_acc_(robot.t_acc),
      jog_(robot),
      usual_t_acc_(robot.t_acc) {
  segment_.target = start;
  const JointVector zero = JointVector::Zero(start.size());
  sample_.reference = {0, start, zero, zero};
  view_.reference = view_.measured = start;
  rest_.q = rest_.trip_q = start;
}

const GeneratorSample& PaulGenerator::advance(std::int64_t period) noexcept {
  catch_up(period);
  while (last_period_ < period) step(cycle_instant(++last_period_, period_));
  return sample_;
}

/// A delay that is too long to be made up is taken out of the path's time.
void PaulGenerator::catch_up(std::int64_t period) noexcept {
  const std::int64_t missed = period - last_period_ - 1;
  if (missed <= most_missed_) return;
  const double lateness = static_cast<double>(missed) * period_;
  clock_.skip(lateness);
  hold();
  last_period_ = period - 1;
  tell({.kind = Kind::Overrun,
        .time = cycle_instant(last_period_, period_),
        .tag = segment_.tag,
        .number = segment_.number,
        .value = lateness});
}

void PaulGenerator::hold() noexcept {
  stopped_ = true;
  clock_.hold();
}

void PaulGenerator::resume() noexcept {
  stopped_ = held_told_ = false;
  if (!handling()) clock_.resume();
}

/// A dwell keeps its share of the run's time: its rest on the path is rescaled.
void PaulGenerator::set_override(double share) noexcept {
  const double before = clock_.override_share();
  clock_.set_override(share);
  if (stands()) clock_.jump();
  if (!dwelling()) return;
  const double rest = end_ - clock_.path_time();
  end_ = milestone_ = clock_.path_time() + rest * (clock_.override_share() / before);
}

bool PaulGenerator::stands() const noexcept {
  const double now = clock_.path_time();
  if (!running_ || segment_.dwell || jogging()) return false;  // the clock knows
  if (segment_.ends_at_rest() && now >= end_ - kSameInstant) return true;
  return from_rest_ && now <= end_ - segment_.span() + kSameInstant;
}

void PaulGenerator::adapt_clock() noexcept {
  const double tightest = buffer_.tightest();
  if (tightest >= tightest_ || !clock_.steady()) return;
  clock_.set_limits(time_scale_limits(reserve_, tightest));
  tightest_ = tightest;
}

/// What may be taken up now.
const SegmentDescriptor* PaulGenerator::next_segment() const noexcept {
  const SegmentDescriptor* const next = buffer_.next_segment();
  return next == nullptr || next->t_acc < tightest_ ? nullptr : next;
}

void PaulGenerator::step(double stamp) noexcept {
  adapt_clock();
  clock_.advance(stamp, !running_ || dwelling() || jogging());
  if (jogging()) {
    run_jog();
  } else if (running_) {
    run_segments();
  }
  fire_path_events();
  if (clock_.braked() && jog_.stands()) end_early(jogging() ? stamp : clock_.steady_since());
  report_held();
  report_handled();
  drop_ended();
  fire_effects(stamp);
  if (!running_) start_from_rest();
  finish_if_done();
  make_sample();
  publish_decidable();
}

/// All that lies between the reference before and this one, in order of time. A motion lasts at
/// least two half transitions, and the buffer holds only so many dwells: the turns are few.
void PaulGenerator::run_segments() noexcept {
  pass_milestone();
  while (running_ && clock_.path_time() > end_ + kSameInstant) {
    decide();
    pass_milestone();
  }
  if (running_ && segment_.ends_at_rest() && clock_.path_time() >= end_ - kSameInstant) arrive();
}

void PaulGenerator::pass_milestone() noexcept {
  if (passed_ >= passing_ || clock_.path_time() < milestone_ - kSameInstant) return;
  passed_ = passing_;
  latest_ = std::max(latest_, clock_.run_time(milestone_));
  fire_effects(latest_);
}

/// At the end of a segment of no length, and of a profile, the axes stand at its target. What
/// follows at this very instant is not decided before the next reference; here it only matters
/// whether anything can.
void PaulGenerator::arrive() noexcept {
  latest_ = std::max(latest_, clock_.run_time(end_));
  close_guard();
  const bool closed = buffer_.closed();
  if (closed && buffer_.next_segment() == nullptr) running_ = false;
}

/// The decision instant has passed: what follows the present segment?
void PaulGenerator::decide() noexcept {
  const bool at_rest = segment_.ends_at_rest();
  if (at_rest) close_guard();
  const bool closed = buffer_.closed();  // before looking: all that was pushed is then seen
  const SegmentDescriptor* next = faulted_ ? nullptr : next_segment();
  const bool jog = next != nullptr && next->jog.present();
  if (next != nullptr && (next->from_rest || jog) && !at_rest) {
    begin_stop(end_);
  } else if (jog) {
    running_ = false;  // it begins at the next stamp
  } else if (next != nullptr && at_rest && hit_at_start(*next, end_)) {
    buffer_.pop_segment();
  } else if (next != nullptr && take_up(*next, end_)) {
    buffer_.pop_segment();
  } else if (at_rest) {
    running_ = false;
  } else {
    if (!closed && !faulted_) {
      late_decisions_.fetch_add(1, std::memory_order_relaxed);
      tell({.kind = Kind::LateDecision,
            .time = clock_.run_time(end_),
            .tag = segment_.tag,
            .number = segment_.number});
    }
    begin_stop(end_);
  }
}

/// Begins `segment` and says so; false, with a fault, if its rates would not be finite. The lowest
/// axis is told.
bool PaulGenerator::take_up(const SegmentDescriptor& segment, double instant) noexcept {
  const bool timed = std::isfinite(segment.duration) && std::isfinite(segment.t_acc);
  for (int i = 0; i < segment_.target.size(); ++i) {
    const double duration = segment.dwell ? 1 : segment.duration;  // a dwell has no rate
    const double rate = (segment.target[i] - segment_.target[i]) / duration;
    if (timed && std::isfinite(rate) && std::isfinite(segment.target[i])) continue;
    fail(segment, i, instant);
    return false;
  }
  begin(segment, instant);
  inserted_ = false;
  tell({.kind = Kind::SegmentStarted,
        .time = clock_.run_time(instant),
        .tag = segment.tag,
        .number = segment.number});
  return true;
}

void PaulGenerator::fail(const SegmentDescriptor& segment, int axis, double instant) noexcept {
  faulted_ = true;
  tell({.kind = Kind::Fault,
        .time = clock_.run_time(instant),
        .tag = segment.tag,
        .number = segment.number,
        .axis = axis});
}

/// S1: A := X, B := C, C := D, T1 := T2, t := −t_acc.
void PaulGenerator::begin(const SegmentDescriptor& segment, double instant) noexcept {
  if (segment.dwell) return begin_dwell(segment, instant);
  if (segment.profile.present()) return begin_profile(segment, instant);
  const bool from_rest = !running_ || segment_.ends_at_rest();
  from_rest_ = from_rest;
  const JointVector b = segment_.target;
  const JointVector a = from_rest ? b : path_.sample(exit()).q;
  if (segment.no_length) {
    path_.stop(a, b, t_acc_, segment.duration);
  } else {
    path_.begin(segment, a, b, t_acc_, from_rest);
  }
  zero_ = instant + t_acc_;
  end_ = zero_ + segment.duration - segment.t_acc;
  const std::uint32_t before = segment_.number;
  segment_ = segment;
  t_acc_ = segment.t_acc;
  running_ = true;
  milestone_ = segment.no_length ? end_ : zero_;
  if (segment.no_length) {
    path_events_.stop(zero_ - instant);
  } else {
    path_events_.begin(segment, zero_, zero_ - instant, from_rest, instant,
                       clock_.override_share());
  }
  passing_ = segment.no_length ? segment.number : before;
}

/// The axes stand already: what comes before a dwell is exact.
void PaulGenerator::begin_dwell(const SegmentDescriptor& segment, double instant) noexcept {
  segment_ = segment;
  t_acc_ = segment.t_acc;
  zero_ = instant;
  end_ = milestone_ = instant + segment.duration * clock_.override_share();
  passing_ = segment.number;
  running_ = true;
}

/// From rest to rest in its own time.
void PaulGenerator::begin_profile(const SegmentDescriptor& segment, double instant) noexcept {
  path_.begin(segment, segment_.target, segment_.target, t_acc_, true);
  segment_ = segment;
  t_acc_ = segment.t_acc;
  from_rest_ = running_ = true;
  zero_ = instant;
  end_ = milestone_ = instant + segment.duration;
  passing_ = segment.number;
  path_events_.begin(segment, zero_, 0, true, instant, clock_.override_share());
}

/// Arrives at the present target and stands there; the present segment goes on owning the time.
void PaulGenerator::begin_stop(double instant) noexcept {
  SegmentDescriptor stop = segment_;
  stop.duration = 2 * t_acc_;
  stop.no_length = true;
  stop.profile = {};
  stop.limit = kLimitEndOfBuffer;
  begin(stop, instant);
  inserted_ = true;
}

void PaulGenerator::start_from_rest() noexcept {
  if (faulted_ || clock_.rate() == 0) return;
  const SegmentDescriptor* next = next_segment();
  if (next == nullptr) return;
  finished_ = false;
  if (clock_.braking()) return;
  if (hit_at_start(*next, clock_.path_time())) return buffer_.pop_segment();
  if (next->jog.present()) return begin_jog(*next, clock_.stamp());
  if (take_up(*next, clock_.path_time())) buffer_.pop_segment();
}

void PaulGenerator::finish_if_done() noexcept {
  if (running_ || finished_ || faulted_ || !buffer_.closed()) return;
  if (buffer_.next_segment() != nullptr || buffer_.next_effect() != nullptr) return;
  finished_ = true;
  tell({.kind = Kind::Finished, .time = latest_, .tag = segment_.tag, .number = segment_.number});
}

void PaulGenerator::report_held() noexcept {
  const bool stands = axes_held() || (faulted_ && !running_);
  const bool asked = stopped_ || !handling() || faulted_;
  if (!stands || held_told_ || !asked) return;
  held_told_ = true;
  const double begun = end_ - exit();
  const bool under_way = running_ && end_ > begun && !jogging();
  const double share = under_way ? (clock_.path_time() - begun) / (end_ - begun) : 1;
  tell({.kind = Kind::Held,
        .time = jogging()       ? clock_.stamp()
                : clock_.held() ? clock_.steady_since()
                                : latest_,
        .tag = segment_.tag,
        .number = segment_.number,
        .value = share});
}

/// Effects that are due, in their order. With the event ring full they wait in the buffer.
void PaulGenerator::fire_effects(double time) noexcept {
  for (const Effect* effect = buffer_.next_effect(); effect != nullptr && !events_.full();
       effect = buffer_.next_effect()) {
    const bool dropped = effect->generation <= ended_ && effect->after > kept_;
    if (!dropped && (effect->after > passed_ || failing())) return;
    arm_or_disarm(*effect, dropped);
    tell({.kind = dropped ? Kind::EffectDropped : Kind::EffectDue,
          .time = time,
          .tag = effect->tag,
          .effect = *effect});
    buffer_.pop_effect();
  }
}

void PaulGenerator::make_sample() noexcept {
  sample_.reference.time = clock_.stamp();
  if (jogging()) {
    follow_jog();
  } else if (running_ && !segment_.dwell) {
    follow_path();
  }
  if (!running_ || segment_.dwell) stand();
  sample_.tag = segment_.tag;
  sample_.piece = segment_.number;
  if (axes_held() || (faulted_ && !running_)) {
    sample_.state = MotionState::Held;
  } else if (!running_) {
    sample_.state = MotionState::Idle;
  } else {
    const MotionState moving = jogging() ? MotionState::Jogging : MotionState::Running;
    sample_.state = clock_.holding() || clock_.braking() ? MotionState::Stopping : moving;
  }
}

/// The chain rule: q' and q'' are along the path's time, which runs at the rate r.
void PaulGenerator::follow_path() noexcept {
  const double r = clock_.rate();
  const double sigma = clock_.path_time() - zero_;
  const PathPoint p = path_.sample(sigma);
  const JointVector qdd = p.qdd * (r * r) + p.qd * clock_.slope();
  for (int i = 0; i < qdd.size(); ++i) {
    if (std::isfinite(p.q[i]) && std::isfinite(p.qd[i]) && std::isfinite(qdd[i])) continue;
    // No descriptor that the planner makes comes here. The last reference is held.
    fail(segment_, i, clock_.path_time());
    segment_.target = sample_.reference.q;
    running_ = false;
    return;
  }
  sample_.reference.q = p.q;
  sample_.reference.qd = p.qd * r;
  sample_.reference.qdd = qdd;
  sample_.sigma = sigma;
  sample_.rate = r;
  const bool slowed = clock_.override_share() < 1 && !inserted_;
  sample_.limit = slowed ? kLimitOverride : segment_.limit;
}

void PaulGenerator::stand() noexcept {
  sample_.reference.q = segment_.target;
  sample_.reference.qd.setZero();
  sample_.reference.qdd.setZero();
  sample_.sigma = dwelling() ? clock_.path_time() - zero_ : exit();
  sample_.rate = dwelling() ? clock_.rate() : 0;
  sample_.limit = 0;
}

/// While an error ends all that was commanded there is nothing to decide: the program learns of it
/// first.
void PaulGenerator::publish_decidable() noexcept {
  if (failing() || untold_) return;
  std::uint32_t number = segment_.number;
  const bool passed = jogging() ? jog_is_over() : clock_.next() > end_ + kSameInstant;
  const bool due = !running_ || inserted_ || passed;
  if (!due) --number;
  if (number > decidable()) decidable_.store(number, std::memory_order_release);
}

void PaulGenerator::tell(MotionEvent event) noexcept {
  event.time = latest_ = std::max(latest_, event.time);
  events_.push(event);
}

}  // namespace rob::motion
