#include "runtime/tick/pressing.h"

namespace rob::runtime {

namespace {

// Backing off (fault 22). [choice] a force that no tool minds, at twice the speed of S4's program;
// 50 N/mm are left within a third of a second
constexpr double kHarmless = 5;      // N
constexpr double kBackSpeed = 0.01;  // m/s
constexpr double kBackTime = 2;      // s

}  // namespace

Pressing::Pressing(const motion::RobotModel& robot, Channels& channels)
    : channels_(channels), press_(robot) {}

/// While the axes are held, or a handler has them, the press stands.
void Pressing::follow(Tracks& tracks, const motion::Wrench& felt, bool held, double now) noexcept {
  PressDesk& desk = channels_.press;
  if (desk.asked.exchange(false, std::memory_order_acquire)) press_.begin(desk.order);
  if (backing_off()) return follow_back_off(tracks, felt, now);
  unpressed_ = tracks.reference().q;
  if (!press_.active()) return;
  const bool over = desk.over.load(std::memory_order_acquire);
  step(tracks, felt, over || held || tracks.handling());
  desk.state.store(state(), std::memory_order_release);
  if (over && press_.stands()) end(tracks.program());
}

void Pressing::step(Tracks& tracks, const motion::Wrench& felt, bool braking) noexcept {
  press_.step(felt, braking);
  press_.shift(tracks.active().current.reference);
}

PressDesk::State Pressing::state() const noexcept {
  using State = PressDesk::State;
  if (press_.lost()) return press_.at_end() ? State::AtEnd : State::Lost;
  return press_.settled() ? State::Keeping : State::Seeking;
}

/// The path begins anew where the axes have come to stand.
void Pressing::end(Track& program) noexcept {
  press_.end();
  const motion::JointVector& q = program.current.reference.q;
  program.generator.stand_at(q);
  channels_.joints.store(q);
  channels_.press.over.store(false, std::memory_order_relaxed);
  channels_.press.state.store(PressDesk::State::Off, std::memory_order_release);
}

void Pressing::follow_back_off(Tracks& tracks, const motion::Wrench& felt, double now) noexcept {
  if (backing_off_ == BackOff::Braking && (!press_.active() || press_.stands()))
    begin_retreat(felt, now);
  const bool done = press_.settled() || press_.lost() || now > retreats_until_;
  if (backing_off_ == BackOff::Retreating && done) backing_off_ = BackOff::Ending;
  if (backing_off_ == BackOff::Ending && press_.stands()) backing_off_ = BackOff::None;
  if (press_.active()) step(tracks, felt, backing_off_ != BackOff::Retreating);
}

void Pressing::begin_retreat(const motion::Wrench& felt, double now) noexcept {
  const double force = felt.force.norm();
  backing_off_ = force > kHarmless ? BackOff::Retreating : BackOff::Ending;
  retreats_until_ = now + kBackTime;
  if (force > kHarmless) press_.begin({felt.force / force, kHarmless, kBackSpeed});
}

}  // namespace rob::runtime
