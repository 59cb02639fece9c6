#include "runtime/control/motion_task.h"

/// The part of MotionTask that keeps a force beside the path of the program.
namespace rob::runtime {

/// While the axes are held, or a handler has them, the press stands.
void MotionTask::follow_press() noexcept {
  PressDesk& desk = channels_.press;
  if (desk.asked.load(std::memory_order_acquire)) {
    press_.begin(desk.order);
    desk.asked.store(false, std::memory_order_relaxed);
  }
  if (!press_.active()) return;
  const bool over = desk.over.load(std::memory_order_acquire);
  press_.step(wrench_, over || paused_ || safe_ || handling());
  press_.shift(active_->current.reference);
  desk.state.store(press_state(), std::memory_order_release);
  if (over && press_.stands()) end_press();
}

PressDesk::State MotionTask::press_state() const noexcept {
  using State = PressDesk::State;
  if (press_.lost()) return State::Lost;
  return press_.settled() ? State::Keeping : State::Seeking;
}

/// The path begins anew where the axes have come to stand.
void MotionTask::end_press() noexcept {
  press_.end();
  const motion::JointVector& q = program_.current.reference.q;
  program_.generator.stand_at(q);
  channels_.joints.store(q);
  channels_.press.over.store(false, std::memory_order_relaxed);
  channels_.press.state.store(PressDesk::State::Off, std::memory_order_release);
}

}  // namespace rob::runtime
