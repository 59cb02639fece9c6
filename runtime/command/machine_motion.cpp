#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "lang/machine/move_pose.h"
#include "runtime/command/robot_machine.h"
#include "runtime/command/tool_paths.h"
#include "runtime/words/codes.h"
#include "runtime/words/messages.h"
#include "runtime/words/path_words.h"
#include "runtime/words/pose_values.h"
#include "runtime/words/units.h"

/// Member functions of RobotMachine that command motions.
namespace rob::runtime {

using lang::MotionKind;
using lang::Reply;

namespace {

/// m by which a MOVEL may leave its line where its axes run straight. [choice] what a common linear
/// scale resolves.
constexpr double kStraight = 1e-6;

motion::ProfileShape profile_of(lang::Profile profile) {
  switch (profile) {
    case lang::Profile::Rectangular:
      return motion::ProfileShape::Rectangular;
    case lang::Profile::Trapezoidal:
      return motion::ProfileShape::Trapezoidal;
    case lang::Profile::Parabolic:
      return motion::ProfileShape::Parabolic;
    case lang::Profile::Cosine:
      return motion::ProfileShape::Cosine;
    case lang::Profile::Unspecified:
      break;
  }
  return motion::ProfileShape::None;
}

motion::MotionRequest::Bound bound_of(lang::MoveCommand::Bound bound) {
  using From = lang::MoveCommand::Bound;
  using To = motion::MotionRequest::Bound;
  return bound == From::Tool ? To::Tool : bound == From::Rotary ? To::Rotary : To::None;
}

motion::JointVector joints_of(const lang::MoveCommand& point, Eigen::Index axes) {
  motion::JointVector q(axes);
  for (Eigen::Index i = 0; i < axes; ++i) q[i] = point.target[static_cast<std::size_t>(i)];
  return q;
}

/// The two lines that a corner belongs to.
std::string meeting(int before, int line) {
  const std::uint32_t first = lang::tagged_place(before).line;
  const std::uint32_t second = lang::tagged_place(line).line;
  return first == second ? fmt::format("two motions of line {}, which meet here,", first)
                         : fmt::format("lines {} and {}, which meet here,", first, second);
}

}  // namespace

motion::MotionRequest::Pace pace_of(lang::MoveCommand::Pace pace) {
  using From = lang::MoveCommand::Pace;
  using To = motion::MotionRequest::Pace;
  return pace == From::ToolSpeed      ? To::ToolSpeed
         : pace == From::AngularSpeed ? To::AngularSpeed
         : pace == From::Share        ? To::Share
                                      : To::Unspecified;
}

motion::MotionRequest request_of(int line, const lang::MoveCommand& command) {
  motion::MotionRequest request;
  request.tag = static_cast<motion::Tag>(line);
  request.relative = command.relative;
  request.given = command.given;
  request.target = command.target;
  request.pace = pace_of(command.pace);
  request.pace_value = command.pace_value;
  request.at_least = command.over;
  request.profile = profile_of(command.profile);
  request.accel = bound_of(command.accel);
  request.accel_value = command.accel_value;
  request.jerk = bound_of(command.jerk);
  request.jerk_value = command.jerk_value;
  if (command.exact()) return request;  // at rest there is no corner to be bounded
  using Zone = motion::MotionRequest::Zone;
  request.zone = command.zone == lang::MoveCommand::Zone::Length  ? Zone::Length
                 : command.zone == lang::MoveCommand::Zone::Time  ? Zone::Time
                 : command.zone == lang::MoveCommand::Zone::Share ? Zone::Share
                                                                  : Zone::Robots;
  request.zone_value = command.zone_value;
  request.zone_angle = command.zone_angle;
  return request;
}

/// What is to be exact takes two segments, which are queued together. In a PATH places wait for its
/// end.
Reply RobotMachine::move(int line, const lang::MoveCommand& asked) {
  if (const Reply reply = tell_load(line); reply != Reply::Done) return reply;
  if (asked.kind == MotionKind::Jog) return jog(line, asked);
  if (!rested()) return Reply::Later;
  const std::size_t needed = (asked.exact() ? 2U : 1U) + (tip_jumps() ? 1U : 0U);
  if (!collecting() && buffer_.room() < needed) return Reply::Later;
  if (collecting() && !path_has_room()) return Reply::Refused;
  const bool stopped = stop_for_tool(line);
  Commanded commanded{{}, false, stopped, asked, setting_, loads_.last()};
  if (!collecting()) commanded.events = std::exchange(on_the_way_, {});
  commanded.via = std::exchange(via_, {});
  commanded.live = std::exchange(live_, std::nullopt);
  if (!plan(line, commanded)) return Reply::Refused;
  for (std::size_t i = 0; i < commanded.events.size(); ++i) log_.queued_effect();
  brakable_ = commanded.segment.number;
  if (!asked.exact()) {
    queue(std::move(commanded));
    return Reply::Done;
  }
  const motion::SettleWindow window = settling_.window(asked.fine_within, planner_.tool_tip());
  if (commanded.segment.ends_at_rest()) settling_.ask(commanded.segment, window);
  queue(std::move(commanded));
  if (auto exact = planner_.stop(static_cast<motion::Tag>(line))) {
    settling_.ask(*exact, window);
    queue(*exact, true, true);
  }
  return Reply::Done;
}

Reply RobotMachine::via(int /*line*/, const lang::MoveCommand& point) {
  via_.push_back(point);
  return Reply::Done;
}

bool RobotMachine::plan(int line, Commanded& commanded) {
  const lang::MoveCommand& asked = *commanded.move;
  if (asked.kind == MotionKind::Jog) return plan_jog(line, asked, commanded.segment);
  if (moves_against_press(commanded)) return false;
  motion::MotionRequest request = request_of(line, asked);
  if (commanded.live) request.live = commanded.live->means;
  const bool led = asked.kind != MotionKind::Joint &&
                   (asked.kind != MotionKind::Line || robot_.tool_coordinates);
  return led ? plan_along(line, request, commanded) : plan_straight(line, commanded);
}

/// In the axes; but a MOVEL whose tip would swing beside its line is led along it.
bool RobotMachine::plan_straight(int line, Commanded& commanded) {
  lang::MoveCommand command = *commanded.move;
  if (settle_target(command) != Reply::Done) return false;
  motion::MotionRequest request = request_of(line, command);
  if (commanded.live) request.live = commanded.live->means;
  if (command.kind == MotionKind::Line && planner_.swing(request) > kStraight)
    return plan_along(line, request, commanded);
  commanded.way = planner_.way(request);
  commanded.along.reset();
  return lay_events(commanded) && take(line, planner_.plan(request), commanded);
}

/// Along a path of the tool.
bool RobotMachine::plan_along(int line, const motion::MotionRequest& request,
                              Commanded& commanded) {
  auto made = tool_path(commanded);
  if (const auto* const words = std::get_if<Words>(&made)) {
    refuse(*words);
    return false;
  }
  const std::shared_ptr<const motion::ToolPath> path =
      std::move(std::get<std::unique_ptr<motion::ToolPath>>(made));
  commanded.way = path->way();
  commanded.along = path;
  const bool planned =
      lay_events(commanded) && take(line, planner_.plan(request, *path), commanded);
  if (planned && commanded.leg && commanded.leg->pace) {
    const motion::PaceLaw& pace = *commanded.leg->pace;
    commanded.segment.on_the_way.change_each([&](motion::PathEvent& event) {
      event.share = pace.time_at(event.share) / pace.duration();
    });
  }
  if (!collecting()) commanded.along.reset();
  return planned;
}

bool RobotMachine::take(int line, const motion::PlanOutcome& outcome, Commanded& commanded) {
  if (const auto* refusal = std::get_if<motion::Refusal>(&outcome)) {
    refuse(words_for(*refusal, robot_));
    return false;
  }
  const auto& planned = std::get<motion::PlannedSegment>(outcome);
  warn(line, commanded, planned);
  line_before_ = line;
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
  return true;
}

/// Where the tip is to be, in the world.
motion::Pose RobotMachine::target_of(const lang::MoveCommand& command) const {
  if (command.means == lang::MoveCommand::Target::Axes) {
    motion::JointVector q = planner_.commanded();
    for (int i = 0; i < q.size(); ++i) {
      const double value = command.target[static_cast<std::size_t>(i)];
      if (command.has(i)) q[i] = command.relative ? q[i] + value : value;
    }
    return to_motion(tool_at(q));
  }
  const lang::PoseValue last = tool_at(planner_.commanded());
  const lang::PoseValue pose = lang::target_pose(command, last, setting_, signature_.coordinates);
  return across_press(to_motion(pose), command);
}

ToolPathOrWords RobotMachine::tool_path(const Commanded& commanded) const {
  const lang::MoveCommand& asked = *commanded.move;
  const motion::Pose from = planner_.tool_pose();
  if (asked.kind == MotionKind::Spiral) {
    const lang::PoseValue frame = setting_.in_tool ? to_lang(from) : setting_.frame;
    return spiral_from(from, to_motion(frame), asked.radius, asked.turns);
  }
  if (asked.kind == MotionKind::Spline && asked.means == lang::MoveCommand::Target::Axes) {
    std::vector<motion::JointVector> joints{planner_.commanded()};
    for (const lang::MoveCommand& point : commanded.via)
      joints.push_back(joints_of(point, joints.front().size()));
    joints.push_back(joints_of(asked, joints.front().size()));
    return joints_through(robot_, planner_.tool(), joints);
  }
  if (asked.euler) return euler_line(from, target_of(asked));
  std::vector<motion::Pose> points{from};
  for (const lang::MoveCommand& point : commanded.via) points.push_back(target_of(point));
  points.push_back(target_of(asked));
  return path_through(asked.kind, points);
}

void RobotMachine::warn(int line, const Commanded& commanded,
                        const motion::PlannedSegment& planned) {
  const lang::Place place = lang::tagged_place(line);
  const bool angle = commanded.move && commanded.move->zone_angle > 0 && !commanded.move->exact();
  if (angle && robot_.law == motion::Law::Paul) {
    log_.found({lang::Severity::Warning, code::kZoneAngleUnused, place,
                "under Paul's law the angle of a ZONE bounds nothing",
                "leave it out, or write LAW LOOKAHEAD"});
  }
  if ((planned.warnings & motion::PlannedSegment::kPaceCut) != 0) {
    const Words words = words_for_pace_cut(planned.pace_cut, robot_);
    log_.found({lang::Severity::Warning, words.code, place, words.message, words.help});
  }
  if ((planned.warnings & motion::PlannedSegment::kStretched) != 0) {
    log_.found({lang::Severity::Warning, code::kTooShort, place,
                fmt::format("OVER is too short: this motion takes {}{} s",
                            robot_.law == motion::Law::Paul ? "" : "at least ",
                            shown(planned.segment.duration, 3)),
                "OVER is a lower bound; the axes and the corners need longer here"});
  }
  if ((planned.warnings & motion::PlannedSegment::kBoundCut) != 0) {
    log_.found({lang::Severity::Warning, code::kBoundCut, place,
                "ACCEL or JERK asks for more than the axes can do",
                "the motion is as quick as its axes permit"});
  }
  if ((planned.warnings & motion::PlannedSegment::kZoneCut) != 0) {
    log_.found({lang::Severity::Warning, code::kZoneCut,
                lang::tagged_place(static_cast<int>(planned.zone_tag)),
                fmt::format("ZONE cannot be used in full: {} are too short for it, and leave {} at"
                            " most, and what a bound on jerk adds to that",
                            meeting(static_cast<int>(planned.zone_tag), line),
                            shown(planned.zone_left, motion::AxisKind::Linear)),
                "a ZONE of that size says so in the program"});
  }
  if ((planned.warnings & motion::PlannedSegment::kZoneRaised) != 0) {
    log_.found({lang::Severity::Warning, code::kZoneRaised, place,
                fmt::format("ZONE asks for a tighter corner than the axes can take; it becomes"
                            " ZONE {}s",
                            shown(planned.segment.t_acc, 3)),
                "FINE reaches the target exactly"});
  }
  if ((planned.warnings & motion::PlannedSegment::kCornerExact) != 0) {
    log_.found({lang::Severity::Warning, code::kCornerExact, place,
                fmt::format("{} have no corner within what the axes can do: the target between them"
                            " is reached exactly",
                            meeting(line_before_, line)),
                "FINE at that target says so; a slower AT or a greater ZONE leaves room for it"});
  }
}

}  // namespace rob::runtime
