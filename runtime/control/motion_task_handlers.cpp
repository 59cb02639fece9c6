#include "motion/plan/watched_action.h"
#include "runtime/control/motion_task.h"

/// The part of MotionTask that gives the axes to the handler of a WHEN, and takes them back.
namespace rob::runtime {

using motion::MotionEvent;
using motion::Rest;

void MotionTask::hand_over_rest(Track& track, const MotionEvent& event) noexcept {
  Rest rest;
  if (!track.generator.take_rest(rest)) return;
  track.progress.rests.push(rest);
  if (rest.outcome == Rest::Outcome::Handled) return begin_handler(rest);
  tell(event);
  // A WHEN that fails while a handler has the axes stops it where it is.
  if (&track == &program_ && handling() && rest.failure()) handlers_.generator.brake();
}

void MotionTask::begin_handler(const Rest& rest) noexcept {
  if (rest.by->kind == motion::WatchedAction::Kind::Call) return;  // the axes go on
  handlers_.generator.stand_at(rest.q);
  handlers_.current.reference = program_.current.reference;
  active_ = &handlers_;
  tell({.kind = MotionEvent::Kind::Handling, .time = rest.time, .tag = rest.by->tag});
}

void MotionTask::take_after_handler() noexcept {
  const auto asked = channels_.after_handler.exchange(AfterHandler::None);
  if (asked == AfterHandler::None) return;
  if (!handling()) return program_.generator.go_on();
  if (asked == AfterHandler::Stop) return handlers_.generator.brake();
  const bool back = asked == AfterHandler::GoOn;
  active_ = &program_;
  if (back) {
    program_.generator.go_on();
  } else {
    const motion::JointVector& q = handlers_.current.reference.q;
    program_.generator.leave_path(q, now_, asked == AfterHandler::LeaveAll);
    program_.current.reference.q = q;
  }
  tell({.kind = MotionEvent::Kind::HandlerOver, .time = now_, .value = back ? 0.0 : 1.0});
}

}  // namespace rob::runtime
