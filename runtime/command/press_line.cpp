#include "runtime/command/press_line.h"

#include <cmath>
#include <utility>

namespace rob::runtime {

namespace {

/// m along the axis of a PRESS that its body may move. [choice] the force corrects it; with the
/// stiffest contact of S4's cells, 150 N/mm, it is 15 N if it comes at once
constexpr double kBeside = 1e-4;

/// m/s along it that a JOG in it may have. [choice] what the arm's bends leave
constexpr double kStill = 1e-5;

}  // namespace

void PressLine::seek(const motion::PressOrder& order) {
  PressDesk& desk = links_.channels.press;
  desk.order = order;
  desk.state.store(PressDesk::State::Seeking, std::memory_order_relaxed);
  desk.asked.store(true, std::memory_order_release);
  state_ = State::Seeking;
}

void PressLine::ask_to_end() {
  PressDesk& desk = links_.channels.press;
  const PressDesk::State now = desk.state.load(std::memory_order_acquire);
  state_ = now == PressDesk::State::Lost    ? State::EndingLost
           : now == PressDesk::State::AtEnd ? State::EndingAtEnd
                                            : State::Ending;
  desk.over.store(true, std::memory_order_release);
}

PressLine::State PressLine::leave() { return std::exchange(state_, State::No); }

/// A place that the program has from HERE is where the force has led the tool; on the path, which
/// the force does not change, it is the same place across the axis.
motion::Pose PressLine::across(motion::Pose target, const lang::MoveCommand& command) const {
  if (!present() || command.relative) return target;
  const Eigen::Vector3d from = links_.planner.tool_pose().position;
  const motion::Pose here = to_motion(surroundings_.tool_at(links_.channels.joints.load()));
  const double along = (target.position - from).dot(axis());
  const double led = (here.position - from).dot(axis());
  if (std::abs(along - led) < kBeside) target.position -= along * axis();
  return target;
}

bool PressLine::forbids(const motion::Pose& target) const {
  if (!present()) return false;
  const Eigen::Vector3d from = links_.planner.tool_pose().position;
  return std::abs((target.position - from).dot(axis())) > kBeside;
}

bool PressLine::forbids(const motion::JogRates& rates) const {
  using Space = motion::JogRates::Space;
  if (!present()) return false;
  constexpr double kInstant = 1e-4;  // s: bends leave a millionth of a speed
  const motion::JointVector q = links_.channels.joints.load();
  const motion::Pose tip = to_motion(surroundings_.tool_at(q));
  Eigen::Vector3d along = rates.rate.head<3>();
  if (rates.space == Space::Tool) along = tip.orientation * along;
  if (rates.space == Space::Joint) {
    const motion::Pose later = to_motion(surroundings_.tool_at(q + rates.rate * kInstant));
    along = (later.position - tip.position) / kInstant;
  }
  return std::abs(along.dot(axis())) > kStill;
}

}  // namespace rob::runtime
