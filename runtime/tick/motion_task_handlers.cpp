#include "motion/plan/watched_action.h"
#include "runtime/tick/motion_task.h"

/// Member functions of MotionTask that give the axes to the handler of a WHEN, and take them back.
namespace rob::runtime {

using motion::MotionEvent;
using motion::Rest;

void MotionTask::hand_over_rest(Track& track, const MotionEvent& event) noexcept {
  Rest rest;
  if (!track.generator.take_rest(rest)) return;
  if (rest.outcome == Rest::Outcome::Handled) return begin_handler(rest);
  track.progress.rests.push(rest);
  tell(event);
  // A WHEN that fails while a handler has the axes stops it where it is.
  if (&track == &program_ && handling() && rest.failure()) handlers_.generator.brake();
}

void MotionTask::begin_handler(const Rest& rest) noexcept {
  if (handlers_barred()) return program_.generator.decline_handler(now_);
  program_.progress.rests.push(rest);
  if (rest.by->kind == motion::WatchedAction::Kind::Call) return;  // the axes go on
  handlers_.generator.stand_at(rest.q);
  handlers_.current.reference = program_.current.reference;
  active_ = &handlers_;
  tell({.kind = MotionEvent::Kind::Handling, .time = rest.time, .tag = rest.by->tag});
}

/// One on the way back would not know where the path was left.
bool MotionTask::handlers_barred() const noexcept {
  return channels_.handlers_barred.load() || retrace_.away();
}

void MotionTask::take_after_handler() noexcept {
  program_.generator.bar_handlers(handlers_barred());
  const auto asked = channels_.after_handler.exchange(AfterHandler::None);
  if (asked == AfterHandler::None) return;
  const bool had_axes = handling();
  const motion::JointVector q = press_.active() ? unpressed_ : active_->current.reference.q;
  program_.current.reference = active_->current.reference;
  active_ = &program_;
  if (asked == AfterHandler::GoOn) program_.generator.go_on(now_);
  if (asked == AfterHandler::Decline) program_.generator.decline_handler(now_);
  const bool left = asked == AfterHandler::Leave || asked == AfterHandler::LeaveAll;
  if (left) {
    program_.generator.leave_path(q, now_, asked == AfterHandler::LeaveAll);
  }
  if (had_axes) {
    tell({.kind = MotionEvent::Kind::HandlerOver, .time = now_, .value = left ? 1.0 : 0.0});
  }
}

}  // namespace rob::runtime
