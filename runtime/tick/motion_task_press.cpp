#include "runtime/tick/motion_task.h"

/// Member functions of MotionTask for forces. They hold a force beside the path of the program, and
/// stop the robot before a force becomes too great.
namespace rob::runtime {

using motion::FollowingFinding;
using motion::MotionState;

namespace {

/// Of the robot's limit, for a program that brakes by itself when that is passed. [choice] what is
/// gone until the axes stand, at S4's 5 mm/s against its stiffest cell, is a third
constexpr double kForPrograms = 1.5;

/// s in which a sensor must tell something new (fault 21).
constexpr double kInsensible = 0.1;

// Backing off (fault 22). [choice] a force that no tool minds, at twice the speed of S4's program;
// 50 N/mm are left within a third of a second
constexpr double kHarmless = 5;      // N
constexpr double kBackSpeed = 0.01;  // m/s
constexpr double kBackTime = 2;      // s

}  // namespace

/// While the axes are held, or a handler has them, the press stands.
void MotionTask::follow_press() noexcept {
  PressDesk& desk = channels_.press;
  if (desk.asked.exchange(false, std::memory_order_acquire)) press_.begin(desk.order);
  if (backing_off_ != BackOff::None) return back_off();
  unpressed_ = active_->current.reference.q;
  if (!press_.active()) return;
  const bool over = desk.over.load(std::memory_order_acquire);
  press_.step(wrench_, over || paused_ || safe_ || handling());
  press_.shift(active_->current.reference);
  desk.state.store(press_state(), std::memory_order_release);
  if (over && press_.stands()) end_press();
}

PressDesk::State MotionTask::press_state() const noexcept {
  using State = PressDesk::State;
  if (press_.lost()) return press_.at_end() ? State::AtEnd : State::Lost;
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

/// A program that brakes by itself in the cycle in which the limit is passed has more room.
void MotionTask::supervise_force() noexcept {
  supervise_sensor();
  const double most = robot_.force.limit;
  const double felt = wrench_.force.norm();
  if (most == 0 || felt <= most) {
    beyond_ = 0;
    yielding_ = false;
    return;
  }
  yielding_ = yielding_ || active_->current.state == MotionState::Stopping;
  if (faulted_ || (felt <= kForPrograms * most && (yielding_ || ++beyond_ < 2))) return;
  Eigen::Index axis = 0;
  wrench_.force.cwiseAbs().maxCoeff(&axis);
  take_finding(now_, {FollowingFinding::Verdict::Stop, FollowingFinding::Cause::Force,
                      static_cast<int>(axis), wrench_.force[axis], most});
  backing_off_ = BackOff::Braking;
}

/// Only where somebody counts on it.
void MotionTask::supervise_sensor() noexcept {
  if (!gauge_.zeroed() && !press_.active()) return;
  const double since = gauge_.insensible_for(now_);
  if (since <= kInsensible) return;
  take_finding(now_, {FollowingFinding::Verdict::Stop, FollowingFinding::Cause::Insensible, -1,
                      since, kInsensible});
}

/// From the path, on which the axes brake, along the force that was too great, until it is
/// harmless.
void MotionTask::back_off() noexcept {
  if (backing_off_ == BackOff::Braking && (!press_.active() || press_.stands())) begin_retreat();
  const bool done = press_.settled() || press_.lost() || now_ > retreats_until_;
  if (backing_off_ == BackOff::Retreating && done) backing_off_ = BackOff::Ending;
  if (backing_off_ == BackOff::Ending && press_.stands()) backing_off_ = BackOff::None;
  if (!press_.active()) return;
  press_.step(wrench_, backing_off_ != BackOff::Retreating);
  press_.shift(active_->current.reference);
}

void MotionTask::begin_retreat() noexcept {
  const double felt = wrench_.force.norm();
  backing_off_ = felt > kHarmless ? BackOff::Retreating : BackOff::Ending;
  retreats_until_ = now_ + kBackTime;
  if (felt > kHarmless) press_.begin({wrench_.force / felt, kHarmless, kBackSpeed});
}

}  // namespace rob::runtime
