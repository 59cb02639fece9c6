#include <algorithm>

#include "motion/generate/segment_generator.h"

/// Member functions of SegmentGenerator that end motions early: guards, braking, and what becomes
/// of everything commanded after them.
namespace rob::motion {

using EventKind = MotionEvent::Kind;

void SegmentGenerator::look(const CycleView& view) noexcept {
  measured_before_ = view_.measured;
  view_ = view;
  if (faulted_) return;
  watches_.ask(
      view,
      [this](const WatchedAction& action) noexcept {
        return action.handled() &&
               (!may_be_handled() || action.retired.load(std::memory_order_relaxed));
      },
      [this](WatchedAction& action, WatchAnswer answer) noexcept {
        return do_watched(action, answer);
      });
  if (!braking_) ask_guard();
  if (settling() && !stopping()) look_at_position();
}

/// False where nothing more is to be asked in this cycle.
bool SegmentGenerator::do_watched(WatchedAction& action, WatchAnswer answer) noexcept {
  if (answer == WatchAnswer::Yes && action.kind == WatchedAction::Kind::Act) {
    tell({.kind = EventKind::ActionDue,
          .time = view_.time,
          .tag = action.tag,
          .effect = action.effect});
    return true;
  }
  if (failing()) return false;  // the first error is the one to mend
  if (answer == WatchAnswer::Yes && action.handled()) {
    begin_handling(action);
    return true;
  }
  trip(answer == WatchAnswer::Yes ? Rest::Outcome::Raised : Rest::Outcome::Failed, &action);
  action.fired.store(true, std::memory_order_relaxed);
  return false;
}

void SegmentGenerator::ask_guard() noexcept {
  if (handling()) return;
  const std::uint32_t number = buffer_.to_be_braked();
  if (number != 0 && number <= segment_.number) return trip(Rest::Outcome::Braked);
  if (!running_ || !segment_.guard.present()) return;
  const WatchAnswer answer = segment_.guard.ask(view_);
  if (answer != WatchAnswer::No) trip(outcome_of(answer));
}

Rest::Outcome SegmentGenerator::outcome_of(WatchAnswer answer) noexcept {
  return answer == WatchAnswer::Yes ? Rest::Outcome::Hit : Rest::Outcome::Failed;
}

/// What is known of a Rest before the axes stand; `time`: when it began.
void SegmentGenerator::begin_rest(Rest::Outcome outcome, WatchedAction* by, double time) noexcept {
  rest_.outcome = outcome;
  rest_.by = by;
  rest_.generation = segment_.generation;
  rest_.number = segment_.number;
  rest_.tag = segment_.tag;
  rest_.trip_time = time;
  rest_.trip_q = view_.measured;
}

/// From now on the axes brake on their path, beyond the end of the segment if need be.
void SegmentGenerator::trip(Rest::Outcome outcome, WatchedAction* by) noexcept {
  begin_rest(outcome, by, view_.time);
  // Behind an error nothing acts that has not acted yet; else what stands before the motion does.
  kept_ = by != nullptr ? passed_ : segment_.number - (segment_.number > 0 ? 1 : 0);
  braking_ = true;
  tell({.kind = outcome == Rest::Outcome::Hit ? EventKind::Hit : EventKind::Braking,
        .time = view_.time,
        .tag = segment_.tag,
        .number = segment_.number});
}

/// A guarded motion that would start from standstill while its condition holds does not start.
bool SegmentGenerator::hit_at_start(const SegmentDescriptor& segment, double instant) noexcept {
  if (!segment.guard.present()) return false;
  const WatchAnswer answer = segment.guard.ask(view_);
  if (answer == WatchAnswer::No) return false;
  segment_.tag = segment.tag;
  segment_.number = segment.number;
  segment_.generation = segment.generation;
  tell({.kind = EventKind::SegmentStarted,
        .time = instant,
        .tag = segment.tag,
        .number = segment.number});
  running_ = false;
  trip(outcome_of(answer));
  return true;
}

/// The axes have come to rest after a trip: the path ends here, and with it its generation. What
/// was commanded before the motion that tripped acts now, since its place is not passed any more.
void SegmentGenerator::end_early(double instant) noexcept {
  stand_at(standing_place());
  drop_path(rest_.generation);
  ended_ = rest_.generation;
  passed_ = segment_.number;
  latest_ = std::max(latest_, instant);
  fire_effects(latest_);
  if (rest_.outcome == Rest::Outcome::Braked) buffer_.braked();
  untold_ = rest_.by != nullptr;
  if (untold_ && handling() && !handled_told_) decline_handler(latest_);
  braking_ = false;
  rest_.q = segment_.target;
  tell_rest(latest_);
}

/// A guarded motion has arrived, and its condition never held.
void SegmentGenerator::close_guard(double instant) noexcept {
  if (!segment_.guard.present() || braking_) return;
  const SegmentDescriptor* const next = next_segment();
  if (next != nullptr && next->no_length && next->guard.present()) return;  // its own exact end
  segment_.guard = {};
  const double time = std::max(latest_, instant);
  begin_rest(Rest::Outcome::Reached, nullptr, time);
  rest_.q = segment_.target;
  tell_rest(time);
}

void SegmentGenerator::tell_rest(double time) noexcept {
  rest_.time = time;
  rests_.push(rest_);
  tell({.kind = EventKind::Rest, .time = time, .tag = rest_.tag, .number = segment_.number});
}

/// A WHEN whose block the program has left is disarmed in any case.
void SegmentGenerator::arm_or_disarm(const Effect& effect, bool dropped) noexcept {
  if (effect.kind == Effect::Kind::Disarm) watches_.disarm(*effect.watched);
  if (effect.kind == Effect::Kind::Arm && !dropped) watches_.arm(*effect.watched);
}

/// Motions of a generation that has ended are skipped; after them the axes stand.
void SegmentGenerator::drop_ended() noexcept {
  for (const SegmentDescriptor* next = next_segment();
       next != nullptr && next->generation <= ended_; next = next_segment()) {
    skip_to(next->number);
    pop_segment();
  }
}

}  // namespace rob::motion
