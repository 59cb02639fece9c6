#include <cmath>
#include <utility>

#include "lang/machine/move_pose.h"
#include "runtime/command/robot_machine.h"
#include "runtime/tick/force_gauge.h"
#include "runtime/words/force_words.h"
#include "runtime/words/messages.h"
#include "runtime/words/pose_values.h"

/// Member functions of RobotMachine for forces: ZERO, PRESS, and what SIMULATE says of them.
namespace rob::runtime {

using lang::Reply;
using State = PressDesk::State;

namespace {

/// m along the axis of a PRESS that its body may move. [choice] the force corrects it; with the
/// stiffest contact of S4's cells, 150 N/mm, it is 15 N if it comes at once
constexpr double kBeside = 1e-4;

/// m/s along it that a JOG in it may have. [choice] what the arm's bends leave
constexpr double kStill = 1e-5;

/// Times the noise of the sensor that a force must be at least. [choice] one is not to be told
/// from none
constexpr double kResolved = 5;

/// Of a frame that SIMULATE speaks in: 1 − the cosine by which its axes may be beside the world's.
/// [choice] 0.08°
constexpr double kAlongWorld = 1e-6;

}  // namespace

/// The frame that IN has named, in the world; of the tool as it is commanded to stand.
motion::Pose RobotMachine::force_frame() const {
  return to_motion(setting_.in_tool ? tool_at(planner_.commanded()) : setting_.frame);
}

Reply RobotMachine::zero_force(int line) {
  if (pressing_ == Pressing::Yes) return refuse(words_for_zero_in_press());
  if (buffer_.effects_full()) return Reply::Later;
  const Reply reply = dwell(line, ForceGauge::kZeroing);
  if (reply != Reply::Done) return reply;
  begun_ = false;
  motion::Effect effect;
  effect.tag = static_cast<motion::Tag>(line);
  effect.kind = motion::Effect::Kind::ZeroForce;
  return queue(effect);
}

Reply RobotMachine::simulate_force(int line, int component, double value, double after) {
  if (!rested()) return Reply::Later;
  const Eigen::Vector3d axis = force_frame().orientation * Eigen::Vector3d::Unit(component % 3);
  Eigen::Index along = 0;
  if (axis.cwiseAbs().maxCoeff(&along) < 1 - kAlongWorld) return refuse(words_for_oblique_force());
  motion::Effect effect;
  effect.kind = motion::Effect::Kind::SimulateForce;
  effect.channel = static_cast<std::uint8_t>(along + (component < 3 ? 0 : 3));
  effect.volts = axis[along] < 0 ? -value : value;
  effect.seconds = after;
  return queue_simulation(line, effect);
}

/// Done when the force has been reached.
Reply RobotMachine::press(int line, const lang::PressCommand& command) {
  PressDesk& desk = channels_.press;
  if (pressing_ == Pressing::Yes) return refuse(words_for_press_in_press());
  if (pressing_ == Pressing::No) {
    if (errand_) return refuse(words_for_press_in_handler());
    const double least = kResolved * robot_.force.noise;
    if (command.force == 0 || std::abs(command.force) < least)
      return refuse(words_for_press_of_nothing(least));
    if (robot_.force.limit > 0 && std::abs(command.force) >= robot_.force.limit)
      return refuse(words_for_press_too_hard(command.force, robot_.force.limit));
    if (const Reply reply = dwell(line, 0); reply != Reply::Done) return reply;  // a mark
    begun_ = false;
    if (!settled()) return Reply::Later;
    desk.order = {force_frame().orientation * Eigen::Vector3d::Unit(command.axis), command.force,
                  command.limit};
    desk.state.store(State::Seeking, std::memory_order_relaxed);
    desk.asked.store(true, std::memory_order_release);
    pressing_ = Pressing::Seeking;
  }
  if (pressing_ != Pressing::Seeking) return leave_press(false);
  const State state = desk.state.load(std::memory_order_acquire);
  if (state == State::Lost || state == State::AtEnd) ask_press_to_end();
  if (state != State::Keeping || interrupted()) return Reply::Later;
  pressing_ = Pressing::Yes;
  return Reply::Done;
}

Reply RobotMachine::end_press(int line) {
  if (pressing_ == Pressing::Yes) {
    if (const Reply reply = stop(line); reply != Reply::Done) return reply;
    if (!stands()) return Reply::Later;
    ask_press_to_end();
  }
  return leave_press(true);
}

/// One that has not come to its force yet is not the block's; its error is the one that is settled.
Reply RobotMachine::give_up_press() {
  if (pressing_ == Pressing::Seeking) ask_press_to_end();
  if (pressing_ == Pressing::No || pressing_ == Pressing::Yes) return Reply::Done;
  return leave_press(true) == Reply::Later ? Reply::Later : Reply::Done;
}

void RobotMachine::ask_press_to_end() {
  PressDesk& desk = channels_.press;
  const State state = desk.state.load(std::memory_order_acquire);
  pressing_ = state == State::Lost    ? Pressing::EndingLost
              : state == State::AtEnd ? Pressing::EndingAtEnd
                                      : Pressing::Ending;
  desk.over.store(true, std::memory_order_release);
}

/// The path goes on from where the axes have come to stand. `met`: what is lost had been met.
Reply RobotMachine::leave_press(bool met) {
  if (channels_.press.state.load(std::memory_order_acquire) != State::Off) return Reply::Later;
  restart_from(channels_.joints.load());
  const Pressing ended = std::exchange(pressing_, Pressing::No);
  if (ended == Pressing::EndingAtEnd) return refuse(words_for_press_at_end(met));
  return ended == Pressing::EndingLost ? refuse(words_for_no_contact(motion::Press::kReach, met))
                                       : Reply::Done;
}

/// A place that the program has from HERE is where the force has led the tool; on the path, which
/// the force does not change, it is the same place across the axis.
motion::Pose RobotMachine::across_press(motion::Pose target,
                                        const lang::MoveCommand& command) const {
  if (pressing_ == Pressing::No || command.relative) return target;
  const Eigen::Vector3d& axis = channels_.press.order.axis;
  const Eigen::Vector3d from = planner_.tool_pose().position;
  const motion::Pose here = to_motion(tool_at(channels_.joints.load()));
  const double along = (target.position - from).dot(axis);
  const double led = (here.position - from).dot(axis);
  if (std::abs(along - led) < kBeside) target.position -= along * axis;
  return target;
}

bool RobotMachine::moves_against_press(const Commanded& commanded) {
  if (pressing_ == Pressing::No) return false;
  const Eigen::Vector3d& axis = channels_.press.order.axis;
  const Eigen::Vector3d from = planner_.tool_pose().position;
  const Eigen::Vector3d to = target_of(*commanded.move).position;
  bool against = std::abs((to - from).dot(axis)) > kBeside;
  for (const lang::MoveCommand& via : commanded.via)
    against = against || std::abs((target_of(via).position - from).dot(axis)) > kBeside;
  if (against) refuse(words_for_motion_against_press());
  return against;
}

bool RobotMachine::jogs_against_press(const motion::JogRates& rates) {
  using Space = motion::JogRates::Space;
  if (pressing_ == Pressing::No) return false;
  constexpr double kInstant = 1e-4;  // s: bends leave a millionth of a speed
  const motion::JointVector q = channels_.joints.load();
  const motion::Pose tip = to_motion(tool_at(q));
  Eigen::Vector3d along = rates.rate.head<3>();
  if (rates.space == Space::Tool) along = tip.orientation * along;
  if (rates.space == Space::Joint)
    along = (to_motion(tool_at(q + rates.rate * kInstant)).position - tip.position) / kInstant;
  if (std::abs(along.dot(channels_.press.order.axis)) <= kStill) return false;
  refuse(words_for_motion_against_press());
  return true;
}

}  // namespace rob::runtime
