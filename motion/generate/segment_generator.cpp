#include "motion/generate/segment_generator.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "motion/space/cycle_instant.h"

namespace rob::motion {

namespace {

using EventKind = MotionEvent::Kind;

/// Missed periods that are made up: 20, or 200 ms where that is more.
std::int64_t most_missed(double period) {
  return std::max<std::int64_t>(20, std::llround(0.2 / period));
}

UnderWay standing_at(const JointVector& start, double period) {
  UnderWay now;
  now.segment.target = start;
  now.stamp = now.stamp_before = -period;
  now.view.reference = now.view.measured = start;
  return now;
}

}  // namespace

SegmentGenerator::SegmentGenerator(const RobotModel& robot, LookAheadBuffer& buffer, PathLaw& law,
                                   const JointVector& start)
    : period_(robot.reference_period),
      most_missed_(most_missed(robot.reference_period)),
      law_(law),
      now_(standing_at(start, robot.reference_period)),
      effects_(buffer, watches_, events_),
      early_(now_, buffer, effects_, events_),
      sequence_(robot, law, now_, effects_, early_, events_) {}

void SegmentGenerator::look(const CycleView& view) noexcept {
  sequence_.keep_measured();
  now_.view = view;
  if (events_.faulted()) return;
  watches_.ask(
      view,
      [this](const WatchedAction& action) noexcept {
        return action.handled() &&
               (!may_be_handled() || action.retired.load(std::memory_order_relaxed));
      },
      [this](WatchedAction& action, WatchAnswer answer) noexcept {
        return do_watched(action, answer);
      });
  if (!early_.braking() && !handler_.has_axes()) early_.ask_guard();
  if (!orders().stop) sequence_.look_at_position();
}

/// False where nothing more may be asked in this cycle.
bool SegmentGenerator::do_watched(WatchedAction& action, WatchAnswer answer) noexcept {
  if (answer == WatchAnswer::Yes && action.kind == WatchedAction::Kind::Act) {
    events_.report({.kind = EventKind::ActionDue,
                    .time = now_.view.time,
                    .tag = action.tag,
                    .effect = action.effect});
    return true;
  }
  if (early_.failing()) return false;  // the first error is the one to mend
  if (answer == WatchAnswer::Yes && action.handled()) {
    begin_handling(action);
    return true;
  }
  early_.trip(answer == WatchAnswer::Yes ? Rest::Outcome::Raised : Rest::Outcome::Failed, &action);
  action.fired.store(true, std::memory_order_relaxed);
  return false;
}

const GeneratorSample& SegmentGenerator::advance(std::int64_t period) noexcept {
  catch_up(period);
  while (last_period_ < period) step(cycle_instant(++last_period_, period_));
  return sequence_.sample();
}

/// A delay that is too long to be made up is taken out of the path's time.
void SegmentGenerator::catch_up(std::int64_t period) noexcept {
  const std::int64_t missed = period - last_period_ - 1;
  if (missed <= most_missed_) return;
  const double lateness = static_cast<double>(missed) * period_;
  sequence_.skip(lateness);
  hold();
  last_period_ = period - 1;
  now_.stamp = cycle_instant(last_period_, period_);
  events_.report({.kind = EventKind::Overrun,
                  .time = now_.stamp,
                  .tag = now_.segment.tag,
                  .number = now_.segment.number,
                  .value = lateness});
}

void SegmentGenerator::step(double stamp) noexcept {
  now_.orders = orders();
  if (now_.dwelling() && now_.orders.stop) sequence_.interrupt_dwell(stamp - now_.stamp);
  now_.stamp_before = now_.stamp;
  now_.stamp = stamp;
  go_on_to_stamp();
  if (const auto since = sequence_.at_rest_since(); early_.braking() && since) end_early(*since);
  report_held();
  report_handled();
  sequence_.drop_ended();
  sequence_.let_effects_act(stamp);
  now_.orders = orders();
  if (!holding()) sequence_.start_from_rest();
  sequence_.finish_if_done();
  sequence_.make_sample();
  sequence_.set_state(state());
  publish_decidable();
}

void SegmentGenerator::go_on_to_stamp() noexcept {
  PathLaw::News news = law_.go_on_to_stamp();
  if (news.skipped != 0) sequence_.skip_to(news.skipped);
  for (; news.late_decisions != 0; --news.late_decisions)
    sequence_.report_late_decision(now_.stamp);
  sequence_.go_on();
}

PathOrders SegmentGenerator::orders() const noexcept {
  return {override_, holding() || early_.braking(), early_.braking()};
}

void SegmentGenerator::set_override(double share) noexcept {
  if (share > 0) override_ = share;
  now_.orders = orders();
  law_.take_share();
}

void SegmentGenerator::report_held() noexcept {
  const bool held = axes_held();
  const bool failed = events_.faulted();
  const bool asked = stopped_ || !handler_.has_axes() || failed;
  if (!(held || (failed && !now_.running)) || held_reported_ || !asked) return;
  held_reported_ = true;
  events_.report({.kind = EventKind::Held,
                  .time = held ? *sequence_.at_rest_since() : events_.latest(),
                  .tag = now_.segment.tag,
                  .number = now_.segment.number,
                  .value = sequence_.share_done()});
}

MotionState SegmentGenerator::state() const noexcept {
  if (axes_held() || (events_.faulted() && !now_.running)) return MotionState::Held;
  if (!now_.running) return early_.untaken() ? MotionState::Stopping : MotionState::Idle;
  if (now_.orders.stop) return MotionState::Stopping;
  return now_.jogging() ? MotionState::Jogging : MotionState::Running;
}

/// While an error ends all that was commanded there is nothing to decide: the program learns of it
/// first.
void SegmentGenerator::publish_decidable() noexcept {
  if (early_.failing() || early_.untaken()) return;
  const std::uint32_t number = sequence_.decided();
  for (std::uint32_t next = decidable() + 1; law_.reports_decisions() && next <= number; ++next) {
    events_.report({.kind = EventKind::DecisionPoint,
                    .time = now_.stamp,
                    .tag = now_.segment.tag,
                    .number = next});
  }
  if (number > decidable()) decidable_.store(number, std::memory_order_release);
}

/// The axes have come to rest after a trip: the path ends here, and with it its generation. An
/// effect that was commanded before the motion that tripped acts now, since its place is not passed
/// any more.
void SegmentGenerator::end_early(double instant) noexcept {
  const std::uint32_t generation = early_.rest().generation;
  stand_at(sequence_.standing_place());
  law_.drop_path(generation);
  effects_.end(generation);
  effects_.pass(now_.segment.number);
  events_.reach(instant);
  sequence_.let_effects_act(events_.latest());
  if (early_.failing() && handler_.has_axes() && handler_.waits())
    decline_handler(events_.latest());
  early_.finish(events_.latest());
}

void SegmentGenerator::brake() noexcept {
  if (!events_.faulted() && !early_.braking()) early_.trip(Rest::Outcome::Braked);
}

void SegmentGenerator::leave_path(const JointVector& q, double time, bool all) noexcept {
  Rest rest = now_.rest(Rest::Outcome::Braked, nullptr, time);
  rest.q = q;
  effects_.keep(effects_.passed());
  stand_at(q);
  for (const SegmentDescriptor* next = law_.next_segment(); next != nullptr;
       next = law_.next_segment()) {
    if (all) now_.segment.number = next->number;
    now_.segment.generation = next->generation;
    law_.pop_segment();
  }
  if (all) effects_.end(now_.segment.generation);
  law_.drop_path(all ? now_.segment.generation : 0);
  effects_.pass(now_.segment.number);
  events_.reach(time);
  early_.cancel();
  go_on(time);
  events_.report(rest, events_.latest(), now_.segment.number);
}

/// One at a time, and none once the program has come to its end.
bool SegmentGenerator::may_be_handled() const noexcept {
  return handler_.free() && !stopped_ && !law_.closed();
}

void SegmentGenerator::begin_handling(WatchedAction& action) noexcept {
  handler_.begin(action);
  if (!handler_.has_axes()) report_handling(now_.view.time);  // else once the axes stand
}

/// Once the axes stand; what was braking then has ended first.
void SegmentGenerator::report_handled() noexcept {
  if (!handler_.has_axes() || handler_.reported() || stopped_) return;
  const auto since = sequence_.at_rest_since();
  if (since && !early_.braking()) report_handling(std::max(events_.latest(), *since));
}

void SegmentGenerator::report_handling(double time) noexcept {
  handler_.set_reported();
  Rest rest = now_.rest(Rest::Outcome::Handled, handler_.action(), now_.view.time);
  rest.q = sequence_.standing_place();
  events_.report(rest, time, now_.segment.number);
}

void SegmentGenerator::go_on(double time) noexcept {
  handler_.end();
  events_.reach(time);
}

/// One that has not begun comes true anew when handlers may begin again.
void SegmentGenerator::bar_handlers(bool barred) noexcept {
  handler_.bar(barred);
  if (barred && handler_.waits()) decline_handler(now_.view.time);
}

void SegmentGenerator::decline_handler(double time) noexcept {
  if (handler_.action() == nullptr) return;
  handler_.action()->fired.store(false, std::memory_order_relaxed);
  watches_.renew(*handler_.action());
  go_on(time);
}

}  // namespace rob::motion
