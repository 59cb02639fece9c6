#include "runtime/words/force_words.h"

#include <fmt/format.h>

#include <cmath>

#include "lang/text/codes.h"
#include "runtime/words/codes.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

const char* in_vain(bool again) {
  return again ? "has lost what it pressed on: nothing was met again" : "has met nothing";
}

}  // namespace

Words words_for_press_at_end(bool again) {
  return {code::kNoContact,
          fmt::format("PRESS {} up to where an axis or the arm ends", in_vain(again)),
          "begin it where the arm has way left along its axis"};
}

Words words_for_no_contact(double reach, bool again) {
  return {code::kNoContact,
          fmt::format("PRESS {} within {}", in_vain(again), shown(reach, motion::AxisKind::Linear)),
          "begin it nearer, for example after MOVEL … UNTIL force.z > 3N; or the force has the "
          "other sign: it is the reaction on the tool"};
}

Words words_for_motion_against_press() {
  return {code::kAgainstPress, "this motion goes along the axis of the PRESS around it",
          "the force decides where the tool is along that axis: move across it, or turn about it"};
}

Words words_for_press_of_nothing(double least) {
  return {
      code::kNotPossible,
      fmt::format("PRESS with so small a force presses on nothing: the sensor resolves {:.2g} N",
                  least),
      "write the force that the tool shall feel, for example PRESS Z 10N"};
}

Words words_for_press_too_hard(double force, double limit) {
  return {code::kNotPossible,
          fmt::format("PRESS with {:.4g} N is not possible: the robot stops at {:.4g} N",
                      std::abs(force), limit),
          "press with less; limit in [force] of the robot file says how much it bears"};
}

Words words_for_zero_in_press() {
  return {code::kNotPossible, "ZERO force is not possible in a PRESS",
          "it would take what is pressed with for nothing: ZERO force before, where nothing is "
          "touched"};
}

Words words_for_press_in_press() {
  return {std::string(lang::code::kPressInPress), "this PRESS begins inside another",
          "leave the one around it first: one force along one axis is kept at a time"};
}

Words words_for_press_in_handler() {
  return {code::kNotPossible, "PRESS is not possible in the handler of a WHEN",
          "let the handler RAISE, and PRESS in the RESCUE after it"};
}

Words words_for_oblique_force() {
  return {code::kNotPossible,
          "SIMULATE of a force needs a frame whose axes lie along those of the world",
          "leave IN out, and say the components along x, y and z of the world"};
}

Words words_for_no_sensor(const motion::RobotModel& robot) {
  return {code::kNotPossible,
          fmt::format("the force sensor of {} has said nothing yet", robot.name),
          "check its power and its cable; a signal can tell of a contact, as in UNTIL DIN[1]"};
}

Words words_for_no_pace() {
  return {code::kNoPace, "the pace of AT LIVE has no value here",
          "its computation divides by nothing, or leaves the numbers: bound it, as in "
          "MAX(0.1, 1 - ABS(torque.z)/1Nm)"};
}

Words words_for_force(const motion::FollowingFinding& finding, const motion::RobotModel& robot) {
  if (finding.cause == motion::FollowingFinding::Cause::Insensible)
    return {code::kInsensible,
            fmt::format("the force sensor of {} has said nothing new for {:.2f} s", robot.name,
                        finding.value),
            "check its cable; the robot has stopped, and what it was doing has not succeeded"};
  return {code::kForceLimit,
          fmt::format("the tool feels {:.0f} N along {} of the world; {:.0f} N are permitted",
                      finding.value, "xyz"[finding.axis], finding.limit),
          "the robot has stopped and backed off; look what the tool met, or guard the motion: "
          "UNTIL ABS(force.z) > 20N"};
}

}  // namespace rob::runtime
