#include "runtime/command/motion_plans.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "lang/machine/move_pose.h"
#include "motion/plan/reach.h"
#include "motion/plan/whole_pose.h"
#include "runtime/command/axis_targets.h"
#include "runtime/command/gripper_elements.h"
#include "runtime/command/motion_requests.h"
#include "runtime/command/path_events.h"
#include "runtime/command/plan_warnings.h"
#include "runtime/words/feature_words.h"
#include "runtime/words/force_words.h"

namespace rob::runtime {

using lang::JogFrame;
using lang::MotionKind;
using lang::MoveCommand;
using motion::JogRates;

namespace {

/// m by which a MOVEL may leave its line where its axes run straight. [choice] what a common linear
/// scale resolves.
constexpr double kStraight = 1e-6;

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

std::optional<Words> MotionPlans::plan(int line, Commanded& commanded) {
  const MoveCommand& asked = *commanded.move;
  if (asked.kind == MotionKind::Jog) return plan_jog(line, asked, commanded.segment);
  if (moves_against_press(commanded)) return words_for_motion_against_press();
  const motion::MotionPlanner::Mark before = links_.planner.mark();
  const CornerBefore last = last_;
  auto words = plan_leg(line, commanded);
  if (!words) {
    commanded.clearance = touching_.in(commanded.setting);
    words = proof_.hit(line, commanded.clearance, before, commanded.segment);
    commanded.known_by = proof_.known_by();
  }
  if (words) {
    links_.planner.go_back(before);
    last_ = last;
  }
  return words;
}

std::optional<Words> MotionPlans::plan_leg(int line, Commanded& commanded) {
  const MoveCommand& asked = *commanded.move;
  const GripperElements hand(asked, links_.signature);
  motion::MotionRequest request = request_for(line, hand.any() ? hand.command() : asked, commanded);
  if (!hand.any()) request.given = 0;  // the path has the target
  request.whole = says_whole(asked) && motion::leaves_open(links_.robot);
  const bool led = !hand.alone() && asked.kind != MotionKind::Joint &&
                   (asked.kind != MotionKind::Line || links_.robot.tool_coordinates);
  return led ? plan_along(line, request, commanded) : plan_straight(line, commanded);
}

motion::MotionRequest MotionPlans::request_for(int line, const MoveCommand& command,
                                               const Commanded& commanded) const {
  motion::MotionRequest request = request_of(line, command);
  if (commanded.live) request.live = commanded.live->means;
  request.free = free_turn(command);
  if (command.near) {
    const auto axes = static_cast<std::size_t>(links_.robot.axis_count());
    request.near = joints_of(std::span(*command.near).first(axes));
  }
  return request;
}

/// In the axes; but a MOVEL whose tip would swing beside its line is led along it.
std::optional<Words> MotionPlans::plan_straight(int line, Commanded& commanded) {
  MoveCommand command = *commanded.move;
  if (auto words = settle_target(command)) return words;
  const motion::MotionRequest request = request_for(line, command, commanded);
  if (command.kind == MotionKind::Line && links_.planner.swing(request) > kStraight)
    return plan_along(line, request, commanded);
  if (auto words = words_against_branch(request, command)) return words;
  commanded.way = links_.planner.way(request);
  commanded.along.reset();
  if (auto words = lay_events(commanded)) return words;
  return take(line, links_.planner.plan(request), commanded);
}

/// NEAR on a line says which branch is expected at its end.
std::optional<Words> MotionPlans::words_against_branch(const motion::MotionRequest& request,
                                                       const MoveCommand& command) const {
  const bool said = command.kind == MotionKind::Line && request.near.has_value();
  if (!said || command.means != MoveCommand::Target::Axes) return std::nullopt;
  const auto axes = static_cast<std::size_t>(links_.robot.axis_count());
  const motion::JointVector q = joints_of(std::span(command.target).first(axes));
  if (motion::is_branch_of(links_.robot, q, *request.near)) return std::nullopt;
  motion::Refusal refusal{motion::Refusal::Kind::OtherBranch};
  refusal.q = q;
  return words_for(refusal, links_.robot);
}

/// Along a path of the tool.
std::optional<Words> MotionPlans::plan_along(int line, const motion::MotionRequest& request,
                                             Commanded& commanded) {
  auto made = tool_path(commanded);
  if (auto* const words = std::get_if<Words>(&made)) return std::move(*words);
  const std::shared_ptr<const motion::ToolPath> path =
      std::move(std::get<std::unique_ptr<motion::ToolPath>>(made));
  commanded.way = path->way();
  commanded.along = path;
  if (auto words = lay_events(commanded)) return words;
  if (auto words = take(line, links_.planner.plan(request, *path), commanded)) return words;
  if (request.whole)
    if (auto words = words_against_c(links_.robot, to_lang(path->at(path->end())),
                                     surroundings_.tool_at(links_.planner.commanded())))
      return words;
  if (commanded.leg && commanded.leg->pace) {
    const motion::PaceLaw& pace = *commanded.leg->pace;
    commanded.segment.on_the_way.change_each([&](motion::PathEvent& event) {
      event.share = pace.time_at(event.share) / pace.duration();
    });
  }
  return std::nullopt;
}

std::optional<Words> MotionPlans::take(int line, const motion::PlanOutcome& outcome,
                                       Commanded& commanded) {
  if (const auto* refusal = std::get_if<motion::Refusal>(&outcome))
    return words_for(*refusal, links_.robot);
  const auto& planned = std::get<motion::PlannedSegment>(outcome);
  report_warnings(links_.log, links_.robot, last_, line, commanded, planned);
  last_ = {line, commanded.move ? commanded.move->zone_line : 0};
  const motion::SegmentDescriptor with_events = std::exchange(commanded.segment, planned.segment);
  motion::SegmentDescriptor& segment = commanded.segment;
  segment.on_the_way = with_events.on_the_way;
  if (commanded.live) {
    segment.live.value = commanded.live->pace.value;
    segment.live.self = commanded.live->pace.self;
  }
  commanded.leg = planned.leg;
  segment.on_the_way.change_each(
      [&](motion::PathEvent& event) { event.effect.after = segment.number; });
  return std::nullopt;
}

std::optional<Words> MotionPlans::plan_jog(int line, const MoveCommand& asked,
                                           motion::SegmentDescriptor& segment) {
  const bool leads = asked.jog != JogFrame::Joint;  // of a program refused before, a pendant's here
  if (auto words = words_against(lang::MotionFeature::Lead, links_.robot); leads && words)
    return words;
  links_.channels.jog_bodies.store(touching_.in(surroundings_.setting()));
  links_.channels.jog_room.want();
  const JogRates rates = rates_of(asked, surroundings_.setting().tool, links_.robot);
  if (press_.forbids(rates)) return words_for_motion_against_press();
  const motion::PlanOutcome outcome = links_.planner.jog(static_cast<motion::Tag>(line), rates);
  if (const auto* const refusal = std::get_if<motion::Refusal>(&outcome))
    return words_for(*refusal, links_.robot);
  segment = std::get<motion::PlannedSegment>(outcome).segment;
  return std::nullopt;
}

bool MotionPlans::moves_against_press(const Commanded& commanded) const {
  if (!press_.present()) return false;
  return press_.forbids(target_of(*commanded.move)) ||
         std::ranges::any_of(
             commanded.via, [&](const MoveCommand& via) { return press_.forbids(target_of(via)); });
}

/// The target of the tip, in the world.
motion::Pose MotionPlans::target_of(const MoveCommand& command) const {
  if (command.means == MoveCommand::Target::Axes) {
    motion::JointVector q = links_.planner.commanded();
    for (int i = 0; i < q.size(); ++i) {
      const double value = command.target[static_cast<std::size_t>(i)];
      if (command.has(i)) q[i] = command.relative ? q[i] + value : value;
    }
    return to_motion(surroundings_.tool_at(q));
  }
  const lang::PoseValue last = surroundings_.tool_at(links_.planner.commanded());
  const lang::PoseValue pose =
      lang::target_pose(command, last, surroundings_.setting(), links_.signature.coordinates);
  return press_.across(to_motion(pose), command);
}

ToolPathOrWords MotionPlans::tool_path(const Commanded& commanded) const {
  const MoveCommand& asked = *commanded.move;
  const motion::Pose from = links_.planner.tool_pose();
  if (asked.kind == MotionKind::Spiral) {
    const lang::Setting& setting = surroundings_.setting();
    const lang::PoseValue frame = setting.in_tool ? to_lang(from) : setting.frame;
    return spiral_from(from, to_motion(frame), asked.radius, asked.turns);
  }
  if (asked.kind == MotionKind::Spline && asked.means == MoveCommand::Target::Axes) {
    std::vector<motion::JointVector> joints{links_.planner.commanded()};
    const auto axes = static_cast<std::size_t>(joints.front().size());
    for (const MoveCommand& point : commanded.via)
      joints.push_back(joints_of(std::span(point.target).first(axes)));
    joints.push_back(joints_of(std::span(asked.target).first(axes)));
    return joints_through(links_.robot, links_.planner.tool(), joints);
  }
  if (asked.euler) return euler_line(from, target_of(asked));
  std::vector<motion::Pose> points{from};
  for (const MoveCommand& point : commanded.via) points.push_back(target_of(point));
  points.push_back(target_of(asked));
  // Free turns go on by the shortest way; the points' own value of it means nothing.
  if (const auto free = free_turn(asked)) {
    for (std::size_t i = 1; i < points.size(); ++i)
      points[i] = motion::nearest_turn(points[i], *free, points[i - 1].orientation);
  }
  return path_through(asked.kind, points);
}

/// A pose becomes the axis values that bring the tip there; and so does a tuple where it is not
/// the axis values themselves.
std::optional<Words> MotionPlans::settle_target(MoveCommand& command) const {
  using Target = MoveCommand::Target;
  if (command.means == Target::Axes) return std::nullopt;
  const lang::Setting& setting = surroundings_.setting();
  const bool of_axes = command.means == Target::Coordinates && !links_.robot.tool_coordinates;
  const auto free = free_turn(command);
  if (of_axes && lang::is_plain(setting) && !free) return std::nullopt;
  const GripperElements hand(command, links_.signature);
  if (hand.alone()) {
    command = hand.command();
    return std::nullopt;
  }
  const lang::PoseValue last = surroundings_.tool_at(links_.planner.commanded());
  lang::PoseValue pose = lang::target_pose(command, last, setting, links_.signature.coordinates);
  if (press_.present()) pose = to_lang(press_.across(to_motion(pose), command));
  auto words = settle_on_axes(links_.robot, pose, near(command), command, setting, free);
  if (hand.any()) hand.add_to(command, links_.planner.commanded());
  return words;
}

/// A tuple means, among all axis values that bring the tip to a target, those that turn as far as
/// it says: MOVE BY (0, 0, 270) does not become 90 degrees the other way.
motion::JointVector MotionPlans::near(const MoveCommand& command) const {
  const motion::RobotModel& robot = links_.robot;
  const lang::Setting& setting = surroundings_.setting();
  motion::JointVector q = links_.planner.commanded();
  if (command.near && command.kind == MotionKind::Joint)
    q = joints_of(std::span(*command.near).first(static_cast<std::size_t>(q.size())));
  const bool of_tuple = command.means == MoveCommand::Target::Coordinates;
  if (!of_tuple || robot.tool_coordinates || command.free != lang::FreeTurn::None) return q;
  const double turned = lang::pose_math::to_fixed(setting.frame.rotation).c -
                        lang::pose_math::to_fixed(setting.tool.tip.rotation).c;
  const auto& coordinates = links_.signature.coordinates;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const auto index = static_cast<std::size_t>(i);
    const bool same =
        index < coordinates.size() && coordinates[index].name == robot.axes[index].name;
    if (!same || !command.has(i) || robot.axes[index].kind != motion::AxisKind::Rotary) continue;
    const bool from_last = command.relative || setting.in_tool;
    q[i] = command.target[index] + (from_last ? q[i] : turned);
  }
  return q;
}

}  // namespace rob::runtime
