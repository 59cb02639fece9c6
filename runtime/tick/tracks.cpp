#include "runtime/tick/tracks.h"

#include "motion/plan/watched_action.h"
#include "motion/space/cycle_instant.h"

namespace rob::runtime {

using motion::MotionEvent;
using motion::MotionState;
using motion::Rest;

Tracks::Tracks(motion::TrajectoryGenerator& program, motion::TrajectoryGenerator& handlers,
               Channels& channels, const motion::JointVector& start)
    : channels_(channels),
      program_{program, channels.program},
      handlers_{handlers, channels.handler} {
  program_.current.reference.q = start;
}

void Tracks::look(const motion::CycleView& seen) noexcept {
  program_.generator.look(seen);
  if (handling()) handlers_.generator.look(seen);
}

void Tracks::advance(std::int64_t number) noexcept {
  for (Track* const track : both()) track->current = track->generator.advance(number);
}

void Tracks::hold() noexcept {
  for (const Track* const track : both()) track->generator.hold();
}

void Tracks::resume() noexcept {
  for (const Track* const track : both()) track->generator.resume();
}

void Tracks::set_override(double share) noexcept {
  for (const Track* const track : both()) track->generator.set_override(share);
}

Track* Tracks::next_due(double until) noexcept {
  const MotionEvent* const first = program_.pending.front();
  const MotionEvent* const second = handlers_.pending.front();
  const bool programs = second == nullptr || (first != nullptr && first->time <= second->time);
  const MotionEvent* const next = programs ? first : second;
  if (next == nullptr || next->time > until + motion::kSameInstant) return nullptr;
  return programs ? &program_ : &handlers_;
}

void Tracks::hand_over_rest(Track& track, const MotionEvent& event, double now,
                            bool barred) noexcept {
  Rest rest;
  if (!track.generator.take_rest(rest)) return;
  if (rest.outcome == Rest::Outcome::Handled) return begin_handler(rest, now, barred);
  track.progress.rests.push(rest);
  channels_.tell(event);
  // A WHEN that fails while a handler has the axes stops it where it is.
  if (&track == &program_ && handling() && rest.failure()) handlers_.generator.brake();
}

void Tracks::begin_handler(const Rest& rest, double now, bool barred) noexcept {
  if (barred) return program_.generator.decline_handler(now);
  program_.progress.rests.push(rest);
  if (rest.by->kind == motion::WatchedAction::Kind::Call) return;  // the axes go on
  handlers_.generator.stand_at(rest.q);
  handlers_.current.reference = program_.current.reference;
  active_ = &handlers_;
  channels_.tell({.kind = MotionEvent::Kind::Handling, .time = rest.time, .tag = rest.by->tag});
}

void Tracks::take_after_handler(const motion::JointVector& q, double now, bool barred) noexcept {
  program_.generator.bar_handlers(barred);
  const auto asked = channels_.after_handler.exchange(AfterHandler::None);
  if (asked == AfterHandler::None) return;
  const bool had_axes = handling();
  program_.current.reference = active_->current.reference;
  active_ = &program_;
  if (asked == AfterHandler::GoOn) program_.generator.go_on(now);
  if (asked == AfterHandler::Decline) program_.generator.decline_handler(now);
  const bool left = asked == AfterHandler::Leave || asked == AfterHandler::LeaveAll;
  if (left) program_.generator.leave_path(q, now, asked == AfterHandler::LeaveAll);
  if (!had_axes) return;
  channels_.tell({.kind = MotionEvent::Kind::HandlerOver, .time = now, .value = left ? 1.0 : 0.0});
}

void Tracks::report_settled() noexcept {
  for (const Track* const track : both()) {
    if (track->current.state != MotionState::Idle) continue;
    track->progress.settled.store(track->current.piece, std::memory_order_release);
  }
}

void Tracks::report_progress() noexcept {
  for (const Track* const track : both()) {
    const bool stands = track->current.state == MotionState::Idle;
    track->progress.standing.store(stands, std::memory_order_relaxed);
    track->progress.decidable.store(track->generator.decidable(), std::memory_order_release);
  }
}

}  // namespace rob::runtime
