#include "runtime/words/path_words.h"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/unit_factors.h"
#include "runtime/words/codes.h"
#include "runtime/words/pose_values.h"
#include "runtime/words/units.h"

namespace rob::runtime {

using motion::Refusal;

namespace {

/// "63.2 mm of 120 mm".
std::string place_on(const Refusal& refusal) {
  const auto kind = refusal.turning ? motion::AxisKind::Rotary : motion::AxisKind::Linear;
  const double scale = shown_per_si(kind);
  constexpr int kDecimals = 2;
  return fmt::format("{} {} of {} {}", shown(refusal.at * scale, kDecimals), unit_name(kind),
                     shown(refusal.way * scale, kDecimals), unit_name(kind));
}

Words words_for_limit(const Refusal& refusal, const motion::RobotModel& robot) {
  const motion::Axis& axis = axis_of(robot, refusal.axis);
  return {code::kPathBeyondLimit,
          fmt::format("axis {} would pass its limit of {} at {}", axis.name,
                      shown(refusal.limit, axis.kind), place_on(refusal)),
          refusal.other
              ? "the target can be reached in another posture, to which no such way leads: MOVE"
                " goes there"
              : "shorten the way, or begin it in another posture, to which MOVE leads"};
}

/// rad: nearer than that to a singular place an axis turns ten times as far as elsewhere. [choice]
/// what is farther is not to blame
constexpr double kNear = 0.1;

Words words_for_weight(const Refusal& refusal, const motion::RobotModel& robot) {
  return {code::kTooHeavy,
          fmt::format("axis {} would bear {} Nm at {}, more than its {} Nm, by weight alone",
                      axis_of(robot, refusal.axis).name, shown(refusal.value, 2), place_on(refusal),
                      shown(refusal.limit, 2)),
          "carry less, go past that place, or in another posture"};
}

}  // namespace

const char* words_for(motion::SingularPlace place) {
  switch (place) {
    case motion::SingularPlace::Wrist:
      return "axes 4 and 6 are nearly in line there";
    case motion::SingularPlace::Shoulder:
      return "the wrist is nearly above axis 1 there";
    case motion::SingularPlace::Elbow:
      return "the arm is nearly stretched or folded there";
    case motion::SingularPlace::Chain:
      return "its axes lose a direction of motion there";
    case motion::SingularPlace::None:
      break;
  }
  return "";
}

Words words_for_pace_cut(const motion::PaceCut& cut, const motion::RobotModel& robot) {
  std::string text = "AT asks for more than the axes can do";
  if (cut.axis >= 0) {
    const auto kind = cut.turning ? motion::AxisKind::Rotary : motion::AxisKind::Linear;
    const auto place = [&](double at) { return shown(at * shown_per_si(kind), 1); };
    text += fmt::format(": axis {} holds it from {} to {} {} of {} {}",
                        axis_of(robot, cut.axis).name, place(cut.from), place(cut.to),
                        unit_name(kind), place(cut.way), unit_name(kind));
  }
  constexpr double kTold = 0.005;  // s: 0.01 s of what is shown
  if (cut.longer >= kTold)
    text += fmt::format("{} the motion takes {} s longer", cut.axis >= 0 ? ", and" : ":",
                        shown(cut.longer, 2));
  return {code::kAboveAxes, text, "the motion runs as fast as its axes permit"};
}

std::string by_how_much(const motion::Shortfall& shortfall) {
  using Kind = motion::Shortfall::Kind;
  constexpr double kShown = 1e-6;  // m: finer than any arm repeats
  const std::string by =
      shown(std::round(shortfall.distance / kShown) * kShown, motion::AxisKind::Linear);
  switch (shortfall.kind) {
    case Kind::Elsewhere:
      return "";
    case Kind::TooFar:
      return fmt::format(": its wrist would have to be {} farther out than it reaches", by);
    case Kind::TooNear:
      return fmt::format(": its wrist would have to be {} nearer to axis 2 than it folds", by);
    case Kind::BesideAxis:
      return fmt::format(": its wrist would have to be {} nearer to axis 1 than it comes", by);
  }
  return "";
}

std::string text_for_nearest(const lang::PoseValue& pose) {
  const lang::FixedAngles angles = lang::pose_math::to_fixed(pose.rotation);
  const auto length = [](double value) { return shown(value * 1e3, 1); };
  const auto angle = [](double value) { return shown(value / kDegree, 2); };
  return fmt::format("; the nearest that it reaches is POSE({}mm, {}mm, {}mm, {}deg, {}deg, {}deg)",
                     length(pose.position.x), length(pose.position.y), length(pose.position.z),
                     angle(angles.a), angle(angles.b), angle(angles.c));
}

Words words_for_half_turn() {
  return {code::kHalfTurn,
          "the tool would turn by 180 deg on this motion, for which there is no shortest way",
          "turn it in two motions, through an orientation between"};
}

Words words_for_no_arc() {
  return {code::kNoCurve,
          "no arc leads through these three points: they lie on a line, or two of"
          " them are one",
          "MOVEL leads along a line; a whole circle takes two arcs"};
}

Words words_for_no_spline() {
  return {code::kNoCurve,
          "no curve leads through these points: two that follow each other are one, or half a turn"
          " apart",
          "leave one of them out, or put another between them"};
}

Words words_for_no_joint_spline() {
  return {code::kNoCurve,
          "no curve leads through these joints: two points that follow each other are one",
          "leave one of them out"};
}

Words words_for_steep_line(bool beginning, double b) {
  return {code::kSteepLine,
          fmt::format("EULER: b is {} at the {} of this line, within 1 deg of {}90 deg, where a and"
                      " c turn about one line",
                      shown(b, motion::AxisKind::Rotary), beginning ? "beginning" : "end",
                      b < 0 ? "-" : ""),
          "leave EULER out: the tool then turns by the shortest rotation"};
}

Words words_for_no_spiral() {
  return {code::kNoCurve,
          "the x axis of the frame stands on the plane of this SPIRAL, which does not know then"
          " where its centre is",
          "IN names a frame whose x axis lies across the tool, for example IN TOOL"};
}

namespace {

/// "JOINTS(10deg, -80.2deg, …)", to 0.1 mm and 0.1°.
std::string text_for_joints(const motion::JointVector& q, const motion::RobotModel& robot) {
  std::string text;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const bool linear = robot.axes[static_cast<std::size_t>(i)].kind == motion::AxisKind::Linear;
    text += fmt::format("{}{}{}", text.empty() ? "" : ", ",
                        shown(linear ? q[i] * 1e3 : q[i] / kDegree, 1), linear ? "mm" : "deg");
  }
  return fmt::format("JOINTS({})", text);
}

Words words_for_other_branch(const Refusal& refusal, const motion::RobotModel& robot) {
  return {
      code::kOtherBranch,
      fmt::format("on this way the axes arrive at {}; NEAR is nearest to another posture at the"
                  " target",
                  text_for_joints(refusal.q, robot)),
      "leave NEAR out, begin in that posture, or write MOVE p NEAR JOINTS(…), which goes to it"};
}

}  // namespace

Words words_for_path(const Refusal& refusal, const motion::RobotModel& robot) {
  if (refusal.kind == Refusal::Kind::PathOutOfReach) {
    return {code::kPathOutOfReach,
            fmt::format("the tool would leave the reach of {} at {}{}{}", robot.name,
                        place_on(refusal), by_how_much(refusal.shortfall),
                        refusal.nearest ? text_for_nearest(to_lang(*refusal.nearest)) : ""),
            "choose a way that stays in reach, or write MOVE, which goes round"};
  }
  if (refusal.kind == Refusal::Kind::OtherBranch) return words_for_other_branch(refusal, robot);
  if (refusal.kind == Refusal::Kind::TooHeavy) return words_for_weight(refusal, robot);
  if (refusal.kind == Refusal::Kind::PathTooLong) {
    return {code::kPathTooLong,
            refusal.at > 0 ? fmt::format("this way is too long to be planned as one: there is room"
                                         " up to {}",
                                         place_on(refusal))
                           : "this way has too many turns, or points too close together beside its"
                             " length, to be planned as one",
            "write it as several motions"};
  }
  if (refusal.kind != Refusal::Kind::PathSingular) return words_for_limit(refusal, robot);
  const char* const why = refusal.q.size() > 0
                              ? words_for(robot.kinematics->nearest_singularity(refusal.q, kNear))
                              : "";
  return {
      code::kPathSingular,
      fmt::format("axis {} would have to turn too fast at {}{}{}",
                  axis_of(robot, refusal.axis).name, place_on(refusal), *why == 0 ? "" : ": ", why),
      "lead the way past that place, leave a turn of the tool open with FREE c or FREE SPIN, begin "
      "in"
      " another posture (MOVE p NEAR JOINTS(…) goes to one), or write MOVE"};
}

}  // namespace rob::runtime
