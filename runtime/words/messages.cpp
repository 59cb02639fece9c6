#include "runtime/words/messages.h"

#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lang/check/fold.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/values/pose_slots.h"
#include "motion/generate/motion_event.h"
#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_library.h"
#include "runtime/tick/simulated_inputs.h"
#include "runtime/words/codes.h"
#include "runtime/words/force_words.h"
#include "runtime/words/path_words.h"
#include "runtime/words/units.h"

namespace rob::runtime {

using motion::FollowingFinding;
using motion::Refusal;

namespace {

Words beyond(const Refusal& refusal, const motion::RobotModel& robot) {
  const motion::Axis& axis = axis_of(robot, refusal.axis);
  const bool below = refusal.kind == Refusal::Kind::BelowMinimum;
  return {code::kBeyondLimit,
          fmt::format("axis {}: {} is {} {}", axis.name, shown(refusal.value, axis.kind),
                      below ? "below" : "beyond", shown(refusal.limit, axis.kind)),
          fmt::format("axis {} of {} reaches from {} to {}", axis.name, robot.name,
                      shown(axis.min, axis.kind), shown(axis.max, axis.kind))};
}

/// The fault in a machine's own words, up to the last semicolon, and the remedy after it.
struct MachineWords {
  explicit MachineWords(const std::string& text) {
    const std::size_t cut = text.rfind("; ");
    what = text.substr(0, cut);
    if (cut != std::string::npos) remedy = text.substr(cut + 2);
  }
  std::string what;
  std::string remedy;
};

/// A finding about an axis, and what the machine shows that explains it.
Words explained(Words words, const std::string& remark) {
  if (remark.empty()) return words;
  const MachineWords machine(remark);
  words.message += ": " + machine.what;
  words.help = machine.remedy;
  return words;
}

Words words_of_machine(FollowingFinding::Cause cause, const std::string& trouble) {
  using Cause = FollowingFinding::Cause;
  const char* const number = cause == Cause::Lost    ? code::kMachineGone
                             : cause == Cause::Alarm ? code::kMachineAlarm
                                                     : code::kNoAnswer;
  const char* const what = cause == Cause::Lost    ? "the machine is gone"
                           : cause == Cause::Alarm ? "the machine itself has stopped"
                                                   : "the machine does not answer";
  const char* const remedy = cause == Cause::Alarm ? "look at the machine for the reason"
                                                   : "check its power and its cable";
  if (trouble.empty()) return {number, what, remedy};
  const MachineWords machine(trouble);
  return {number, machine.what, machine.remedy};
}

Words words_for_axis(const FollowingFinding& finding, const motion::Axis& axis) {
  using Cause = FollowingFinding::Cause;
  const std::string value = shown(finding.value, axis.kind);
  const std::string limit = shown(finding.limit, axis.kind);
  switch (finding.cause) {
    case Cause::FollowingError:
      return {code::kFollowingError,
              fmt::format("axis {} is {} off its reference; {} are permitted at this speed",
                          axis.name, value, limit),
              "look for what blocks the axis, or lower the speed"};
    case Cause::Frozen:
      return {code::kEncoderFrozen,
              fmt::format("the encoder of axis {} stands still while the reference went away by {}",
                          axis.name, value),
              "check the encoder and its cable, and whether the axis is blocked"};
    case Cause::Jump:
      return {code::kEncoderJump,
              fmt::format("the encoder of axis {} jumped by {}; the axis can move {} in that time",
                          axis.name, value, limit),
              "check the encoder's cable and shielding; the position is not to be trusted"};
    default:
      return {code::kEncoderNoNumber,
              fmt::format("axis {} reports no number as its position", axis.name),
              "check the encoder and its cable"};
  }
}

}  // namespace

Words words_for(const Refusal& refusal, const motion::RobotModel& robot) {
  switch (refusal.kind) {
    case Refusal::Kind::BelowMinimum:
    case Refusal::Kind::AboveMaximum:
      return beyond(refusal, robot);
    case Refusal::Kind::NotFinite:
      return {code::kTargetNotFinite,
              fmt::format("axis {}: the target is not a finite number",
                          axis_of(robot, refusal.axis).name),
              "check the calculation of this target"};
    case Refusal::Kind::BadPace:
      return {code::kPaceRefused,
              fmt::format("AT needs a speed above zero; this is {}", refusal.value),
              "write for example AT 10mm/s or AT 50%"};
    case Refusal::Kind::BadDuration:
      return {code::kDurationRefused,
              fmt::format("OVER needs a time of at least zero; this is {} s", refusal.value),
              "write for example OVER 3s"};
    case Refusal::Kind::BadZone:
      return {code::kZoneRefused,
              fmt::format("ZONE needs a number of zero or more; this is {}", refusal.value),
              "write for example ZONE 5mm"};
    case Refusal::Kind::BadBound:
      return {code::kBoundRefused,
              fmt::format("ACCEL and JERK need a number above zero; this is {}", refusal.value),
              "write for example ACCEL 100mm/s^2"};
    case Refusal::Kind::PathOutOfReach:
    case Refusal::Kind::PathBelowMinimum:
    case Refusal::Kind::PathAboveMaximum:
    case Refusal::Kind::PathSingular:
    case Refusal::Kind::PathTooLong:
      return words_for_path(refusal, robot);
    case Refusal::Kind::TooHeavy:
    case Refusal::Kind::OtherBranch:
      return words_for_path(refusal, robot);
    case Refusal::Kind::TooLong:
      return {code::kMotionTooLong,
              fmt::format("this motion would take {} s; at most {} s are accepted", refusal.value,
                          refusal.limit),
              "raise AT, or lower OVER or ZONE"};
  }
  return {};
}

Words words_for_long_wait(double seconds) {
  return {code::kWaitTooLong,
          fmt::format("this WAIT would take {} s; at most {} s are accepted", seconds,
                      motion::MotionPlanner::kLongest),
          "wait for a signal, or in a loop"};
}

Words words_for_nobody(const char* what) {
  const bool halt = std::string_view(what) == "HALT";
  return {
      std::string(lang::code::kNobodyThere),
      fmt::format("{} waits for the operator, and nobody is there", what),
      fmt::format("run it on a terminal, or with a signal script (--signals) that has: at 2s {};"
                  " a TEST has SIMULATE {}",
                  halt ? "GO = ON" : "ANSWER = \"7\"", halt ? "GO = ON" : "ANSWER = \"7\"")};
}

Words words_for_endless_hold() {
  return {std::string(lang::code::kNobodyThere),
          "the signal script holds the robot (HOLD = ON), and nothing lets it go on",
          "add a later line such as: at 5s GO = ON"};
}

Words words_for_place(double distance, double way) {
  const auto length = motion::AxisKind::Linear;
  return {code::kPlaceBeyond,
          way > 0 ? fmt::format("{} is beyond this motion, whose way is {} long",
                                shown(distance, length), shown(way, length))
                  : "the tool has no way to go in this motion",
          "AFTER counts from the beginning of the motion, BEFORE from its end"};
}

Words words_for_many_places(std::size_t most) {
  return {code::kManyPlaces,
          fmt::format("more than {} places lie on one motion of this PATH", most),
          "divide that motion by a further target on its way"};
}

Words words_for_long_path(std::size_t most) {
  return {
      code::kManyInPath, fmt::format("this PATH has more than {} motions", most),
      "motions blend outside of a PATH, too: leave PATH and ENDPATH out, or make several of it"};
}

Words words_for_condition(lang::ArithmeticError error) {
  const lang::ArithmeticErrorText text = lang::describe(error);
  return {
      std::string(text.code),
      fmt::format("{}, in the condition that is looked at in every control cycle", text.message),
      std::string(text.help)};
}

Words words_for_unreachable(const motion::RobotModel& robot, const lang::PoseValue& pose,
                            const motion::Shortfall& shortfall,
                            const std::optional<lang::PoseValue>& nearest) {
  return {std::string(lang::code::kUnreachable),
          fmt::format("{} cannot bring its tool to {}{}{}", robot.name,
                      lang::text_of(lang::constant_of(lang::from_si(pose)), lang::Type::pose()),
                      by_how_much(shortfall), nearest ? text_for_nearest(*nearest) : ""),
          fmt::format("{} {}", robot.name, robot.kinematics->reach())};
}

Words words_for_unreachable(const motion::RobotModel& robot, const lang::PoseValue& pose,
                            motion::Freedom free) {
  return {std::string(lang::code::kUnreachable),
          fmt::format("{} cannot bring its tool to {}, whatever the turn that FREE {} leaves open",
                      robot.name,
                      lang::text_of(lang::constant_of(lang::from_si(pose)), lang::Type::pose()),
                      free == motion::Freedom::C ? "c" : "SPIN"),
          fmt::format("{} {}", robot.name, robot.kinematics->reach())};
}

Words words_for_other_c(const motion::RobotModel& robot, const lang::PoseValue& pose, double c) {
  constexpr int kDecimals = 2;
  const auto degrees = [](double value) { return shown(value / kDegree, kDecimals); };
  return {std::string(lang::code::kUnreachable),
          fmt::format("{} cannot turn its tool to c = {}deg at this place: with its axes c is {}deg"
                      " there",
                      robot.name, degrees(lang::pose_math::to_fixed(pose.rotation).c), degrees(c)),
          "write the target without c, as (x, y, z, a, b), or FREE c after it"};
}

Words words_for_many_simulations() {
  return {code::kManySimulations,
          fmt::format("more than {} SIMULATEs wait for their time", SimulatedInputs::kMostWaiting),
          "set what comes later when the TEST has come so far"};
}

Words words_for(const FollowingFinding& finding, const motion::RobotModel& robot,
                const std::string& of_machine) {
  if (finding.cause == FollowingFinding::Cause::Overrun) return words_for_overrun(finding.value);
  if (finding.cause == FollowingFinding::Cause::Noisy) {
    return {code::kNoisyWire,
            fmt::format("{:.0f} % of what goes over the wire of the machine is repeated",
                        100 * finding.value),
            "check its cable, its shielding and its earth"};
  }
  if (finding.cause == FollowingFinding::Cause::Saturated) {
    return {code::kDrivesAtLimit,
            fmt::format("the drives are asked for {:.2g} times what they have; the path is slowed "
                        "down until they can follow",
                        finding.value),
            "lower the speed, raise t_acc or lighten the load"};
  }
  if (finding.cause == FollowingFinding::Cause::Force ||
      finding.cause == FollowingFinding::Cause::Insensible)
    return words_for_force(finding, robot);
  if (finding.axis < 0) return words_of_machine(finding.cause, of_machine);
  return explained(words_for_axis(finding, axis_of(robot, finding.axis)), of_machine);
}

namespace {

/// `stops`: what JogRoom says.
std::string text_for_jog_at_body(double stops, const motion::Clearance* bodies) {
  const bool known =
      bodies != nullptr && stops >= 0 && stops < static_cast<double>(bodies->pairs().size());
  if (!known) return "the jog stops short of a body";
  const motion::Clearance::Pair& pair = bodies->pairs()[static_cast<std::size_t>(stops)];
  return fmt::format("the jog stops: {} is near {}", bodies->name_of_body(pair),
                     bodies->name_of_other(pair));
}

}  // namespace

std::string text_for_stopped_jog(int axis, double place, const motion::RobotModel& robot,
                                 const motion::Clearance* bodies) {
  if (axis == motion::MotionEvent::kAtBody) return text_for_jog_at_body(place, bodies);
  if (axis < 0) return "the jog stops at a singular position, or at the end of the arm's reach";
  const motion::Axis& stopping = axis_of(robot, axis);
  const double end = place - stopping.min < stopping.max - place ? stopping.min : stopping.max;
  return fmt::format("axis {} stops the jog: it ends at {}", stopping.name,
                     shown(end, stopping.kind));
}

std::string text_for_missed_lead(double error) {
  return fmt::format("a path event with LEAD came {} s too {}", shown(std::abs(error), 3),
                     error > 0 ? "early" : "late");
}

Words words_for_cut_lead(double late) {
  return {code::kLeadCut,
          fmt::format("the motion does not take as long to this place as LEAD asks for: the event"
                      " comes as the motion begins, {} s late",
                      shown(late, 3)),
          "make LEAD shorter, or set the output before the motion and WAIT"};
}

Words words_for_overrun(double lateness) {
  return {code::kOverrun,
          fmt::format("motion control came {:.0f} ms late, more than can be made up; the robot was"
                      " stopped",
                      lateness * 1e3),
          "start the program again; see docs/realtime.md if it happens often"};
}

Words words_for_unsettled(const motion::PositionError& off, const motion::RobotModel& robot) {
  using Kind = motion::PositionError::Kind;
  if (off.kind == Kind::None) {
    return {code::kUnsettled,
            fmt::format("the robot still moves {} s after its reference has come to rest",
                        shown(robot.settle.time, 3)),
            "look for what swings or pulls at the robot, or move more slowly"};
  }
  const auto unit = off.kind == Kind::Place ? motion::AxisKind::Linear : motion::AxisKind::Rotary;
  const std::string what = off.kind == Kind::Axis ? "axis " + axis_of(robot, off.axis).name + " is"
                           : off.kind == Kind::Place ? "the tool is"
                                                     : "the tool is turned by";
  return {code::kUnsettled,
          fmt::format("{} {}{} {} s after its reference has come to rest; {} are permitted", what,
                      shown(off.value, unit), off.kind == Kind::Turn ? "" : " off",
                      shown(robot.settle.time, 3), shown(off.limit, unit)),
          "look for what pulls at the robot or blocks it, allow more, or move more slowly"};
}

lang::Diagnostic note_on_settling() {
  return {lang::Severity::Note,
          code::kSettlesLater,
          {},
          "times are those of the references: what the robot takes until it is measured in "
          "position comes on top",
          "`rob run --fast` shows it for the simulated robot"};
}

Words words_for_not_finite(int axis, const motion::RobotModel& robot) {
  return {code::kReferenceNotFinite,
          fmt::format("the reference of axis {} is not a finite number; it was not sent",
                      axis_of(robot, axis).name),
          "this is a fault of Rob's own; please report it with the program"};
}

Words words_for_unknown_robot(const std::string& name) {
  return {code::kUnknownRobot, fmt::format("there is no robot \"{}\"", lang::shortened(name)),
          fmt::format("known are {}; another one comes with --robot FILE.toml",
                      fmt::join(motion::robot_names(), ", "))};
}

Words words_for_other_robot(const std::string& declared, const std::string& asked) {
  return {code::kOtherRobot,
          fmt::format("this program is for \"{}\", and --robot names \"{}\"",
                      lang::shortened(declared), asked),
          "leave --robot out, or name a file of the program's robot"};
}

}  // namespace rob::runtime
