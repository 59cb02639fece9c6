#include <algorithm>
#include <optional>

#include "lang/move_pose.h"
#include "lang/pose_slots.h"
#include "motion/plan/reach.h"
#include "runtime/control/messages.h"
#include "runtime/control/robot_machine.h"

/// The part of RobotMachine that tells where the robot is, and where it would be.
namespace rob::runtime {

using lang::Reading;
using lang::Reply;

namespace {

lang::PoseValue to_lang(const motion::Pose& pose) {
  const Eigen::Vector3d& place = pose.position;
  const Eigen::Quaterniond& turn = pose.orientation;
  // + 0.0: the language knows no -0.
  return {{place.x() + 0.0, place.y() + 0.0, place.z() + 0.0},
          {turn.w() + 0.0, turn.x() + 0.0, turn.y() + 0.0, turn.z() + 0.0}};
}

motion::Pose to_motion(const lang::PoseValue& pose) {
  const auto& [place, turn] = pose;
  return {Eigen::Vector3d(place.x, place.y, place.z),
          Eigen::Quaterniond(turn.w, turn.i, turn.j, turn.k)};
}

motion::JointVector to_motion(std::span<const double> joints) {
  motion::JointVector q(static_cast<Eigen::Index>(joints.size()));
  std::ranges::copy(joints, q.begin());
  return q;
}

/// Axis values for a pose, or why there are none.
std::optional<Words> axes_for(const motion::RobotModel& robot, const lang::PoseValue& pose,
                              const motion::JointVector& near, std::span<double> joints) {
  if (robot.kinematics == nullptr) return words_for_no_kinematics(robot);
  const auto q = motion::reach(robot, to_motion(pose), near);
  if (!q) return words_for_unreachable(robot, pose);
  std::ranges::transform(*q, joints.begin(), [](double axis) { return axis + 0.0; });
  return std::nullopt;
}

}  // namespace

std::optional<Words> settle_on_axes(const motion::RobotModel& robot, const lang::PoseValue& pose,
                                    const motion::JointVector& near, lang::MoveCommand& command) {
  const auto words = axes_for(robot, pose, near, command.target);
  command.means = lang::MoveCommand::Target::Axes;
  command.relative = false;
  command.count = robot.axis_count();
  command.given = lang::given_all(command.count);
  return words;
}

/// Behind an exact motion no blend is lost by waiting until the axes stand, and only then are they
/// where the program sent them.
bool RobotMachine::place_can_be_read() const {
  const bool stands = channels_.settled.load(std::memory_order_acquire) >= planner_.last_number();
  return observable() && (!exact_ || stands);
}

Reply RobotMachine::read(int /*line*/, Reading what, lang::Slot* value) {
  if (is_observation(what) && !place_can_be_read()) return Reply::Later;
  return present(what, value);
}

Reply RobotMachine::present(Reading what, lang::Slot* value) {
  const motion::JointVector q =
      is_observation(what) ? channels_.joints.load() : planner_.commanded();
  switch (what) {
    case Reading::Clock: {
      const std::int64_t cycle = channels_.cycle.load(std::memory_order_relaxed);
      value->real = static_cast<double>(cycle) * robot_.reference_period;
      return Reply::Done;
    }
    case Reading::Joints:
      for (const double axis : q) (value++)->real = axis + 0.0;
      return Reply::Done;
    case Reading::Here:
    case Reading::Target:
      break;
  }
  lang::PoseValue pose;
  const Reply reply = tool_at(q, pose);
  if (reply == Reply::Done) lang::store(pose, value);
  return reply;
}

Reply RobotMachine::tool_at(const motion::JointVector& q, lang::PoseValue& pose) {
  if (robot_.kinematics == nullptr) {
    refusal_ = words_for_no_kinematics(robot_);
    return Reply::Refused;
  }
  pose = to_lang(robot_.kinematics->forward(q));
  return Reply::Done;
}

/// HERE was read just before, at rest: the axes are still told to stand where it was.
Reply RobotMachine::teach(int /*line*/, std::string_view point, std::string_view frame,
                          const lang::PoseValue& pose) {
  if (keeper_ == nullptr) return Reply::Done;
  const motion::JointVector q = channels_.joints.load();
  const auto refusal =
      keeper_->keep(point, frame, pose, {q.data(), static_cast<std::size_t>(q.size())});
  if (!refusal) return Reply::Done;
  refusal_ = *refusal;
  return Reply::Refused;
}

Reply RobotMachine::forward(int /*line*/, std::span<const double> joints, lang::PoseValue& pose) {
  return tool_at(to_motion(joints), pose);
}

Reply RobotMachine::inverse(int /*line*/, const lang::PoseValue& pose, std::span<const double> near,
                            std::span<double> joints) {
  const motion::JointVector from = near.empty() ? planner_.commanded() : to_motion(near);
  if (const auto words = axes_for(robot_, pose, from, joints)) {
    refusal_ = *words;
    return Reply::Refused;
  }
  return Reply::Done;
}

/// A pose becomes the axis values that bring the tool there.
Reply RobotMachine::settle_target(lang::MoveCommand& command) {
  if (command.means != lang::MoveCommand::Target::Pose) return Reply::Done;
  lang::PoseValue last{};
  if (command.relative) {
    if (const Reply reply = tool_at(planner_.commanded(), last); reply != Reply::Done) return reply;
  }
  const lang::PoseValue pose = lang::target_pose(command, last);
  if (const auto words = settle_on_axes(robot_, pose, planner_.commanded(), command)) {
    refusal_ = *words;
    return Reply::Refused;
  }
  return Reply::Done;
}

}  // namespace rob::runtime
