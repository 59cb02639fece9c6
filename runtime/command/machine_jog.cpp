#include <algorithm>
#include <variant>

#include "runtime/command/robot_machine.h"
#include "runtime/words/feature_words.h"
#include "runtime/words/messages.h"
#include "runtime/words/pose_values.h"

/// Member functions of RobotMachine that command motions at given rates. Their end is known only
/// after the axes have come to rest; before that only another JOG may follow.
namespace rob::runtime {

using lang::JogFrame;
using lang::MoveCommand;
using lang::Reply;
using motion::JogRates;

namespace {

/// The six rates of the tool. A robot whose coordinates are its axes names those that it has.
motion::JointVector tool_rates(const MoveCommand& command, const motion::Kinematics& kinematics) {
  motion::JointVector rate = motion::JointVector::Zero(6);
  for (int i = 0; i < command.count; ++i)
    rate[kinematics.coordinate(i)] = command.target[static_cast<std::size_t>(i)];
  return rate;
}

void bound(const MoveCommand& command, JogRates& rates) {
  switch (command.pace) {
    case MoveCommand::Pace::Share:
      rates.share = std::min(command.pace_value, 1.0);
      return;
    case MoveCommand::Pace::ToolSpeed:
      rates.tool_speed = command.pace_value;
      return;
    case MoveCommand::Pace::AngularSpeed:
      rates.turning_speed = command.pace_value;
      return;
    case MoveCommand::Pace::Unspecified:
      return;
  }
}

JogRates rates_of(const MoveCommand& command, const lang::ToolValue& tool,
                  const motion::RobotModel& robot) {
  const int axes = robot.axis_count();
  JogRates rates;
  if (command.jog == JogFrame::Joint) {
    rates.space = JogRates::Space::Joint;
    rates.rate.setZero(axes);
    for (int i = 0; i < axes; ++i) rates.rate[i] = command.target[static_cast<std::size_t>(i)];
  } else {
    rates.space = command.jog == JogFrame::World ? JogRates::Space::World : JogRates::Space::Tool;
    rates.rate = tool_rates(command, *robot.kinematics);
  }
  rates.tip = to_motion(tool.tip);
  if (command.lasts > 0) rates.lasts = command.lasts;
  bound(command, rates);
  return rates;
}

}  // namespace

/// A jog begins at rest, or joins one before it.
Reply RobotMachine::jog(int line, const MoveCommand& asked) {
  rested();
  if (buffer_.room() < 2) return Reply::Later;
  const auto exact = planner_.stop(static_cast<motion::Tag>(line));
  if (exact) queue(*exact, true);
  motion::SegmentDescriptor segment;
  if (!plan_jog(line, asked, segment)) return Reply::Refused;
  brakable_ = segment.number;
  moved_tip_ = setting_.tool.tip.position;
  queue({segment, false, exact.has_value(), asked, setting_, {}});
  return Reply::Done;
}

bool RobotMachine::plan_jog(int line, const MoveCommand& asked,
                            motion::SegmentDescriptor& segment) {
  const bool leads = asked.jog != JogFrame::Joint;  // of a program refused before, a pendant's here
  if (const auto words = words_against(lang::MotionFeature::Lead, robot_); leads && words) {
    refuse(*words);
    return false;
  }
  const JogRates rates = rates_of(asked, setting_.tool, robot_);
  if (jogs_against_press(rates)) return false;
  const motion::PlanOutcome outcome = planner_.jog(static_cast<motion::Tag>(line), rates);
  if (const auto* const refusal = std::get_if<motion::Refusal>(&outcome)) {
    refuse(words_for(*refusal, robot_));
    return false;
  }
  segment = std::get<motion::PlannedSegment>(outcome).segment;
  return true;
}

/// Jogs that came to rest before the one after them was known have told so, too.
bool RobotMachine::take_jog_rest(motion::Rest& rest) {
  while (take_rest(rest)) {
    if (rest.early() || rest.number == planner_.last_number()) return true;
  }
  return false;
}

bool RobotMachine::rested() {
  if (!jogging_) return true;
  motion::Rest rest;
  if (!take_jog_rest(rest)) return false;
  rest.early() ? restart_from(rest.q) : come_to_rest(rest.q);
  return true;
}

void RobotMachine::come_to_rest(const motion::JointVector& q) {
  planner_.stand_at(q, planner_.last_number());
  exact_ = true;
  jogging_ = false;
}

void RobotMachine::restart_from(const motion::JointVector& q) {
  drop_path();
  planner_.retarget(q);
  loads_.doubt_where_told(channels_.carried.load(std::memory_order_acquire));
  exact_ = true;
  jogging_ = false;
  settling_.lose();
}

}  // namespace rob::runtime
