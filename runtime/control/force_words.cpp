#include "runtime/control/force_words.h"

#include <fmt/format.h>

#include "runtime/control/codes.h"
#include "runtime/control/units.h"

namespace rob::runtime {

Words words_for_no_contact(double reach, bool again) {
  return {
      code::kNoContact,
      fmt::format("PRESS {} within {}",
                  again ? "has lost what it pressed on: nothing was met again" : "has met nothing",
                  shown(reach, motion::AxisKind::Linear)),
      "begin it nearer, for example behind MOVEL … UNTIL force.z > 3N; or the force has the "
      "other sign: it is the reaction on the tool"};
}

Words words_for_motion_against_press() {
  return {code::kAgainstPress, "this motion goes along the axis of the PRESS around it",
          "the force decides where the tool is along that axis: move across it, or turn about it"};
}

Words words_for_press_of_nothing() {
  return {code::kNotPossible, "PRESS with a force of 0 N presses on nothing",
          "write the force that the tool shall feel, for example PRESS Z 10N"};
}

Words words_for_press_in_handler() {
  return {code::kNotPossible, "PRESS is not possible in the handler of a WHEN",
          "let the handler RAISE, and PRESS in the RESCUE behind it"};
}

Words words_for_oblique_force() {
  return {code::kNotPossible,
          "SIMULATE of a force needs a frame whose axes lie along those of the world",
          "leave IN out, and say the components along x, y and z of the world"};
}

Words words_for_no_sensor(const motion::RobotModel& robot) {
  return {code::kNotPossible,
          fmt::format("the force sensor of {} has told nothing yet", robot.name),
          "check its power and its cable; a signal can tell of a contact, as in UNTIL DIN[1]"};
}

Words words_for_no_pace() {
  return {code::kNoPace, "the pace of AT LIVE has no value here",
          "its computation divides by nothing, or leaves the numbers: bound it, as in "
          "MAX(0.1, 1 - ABS(torque.z)/1Nm)"};
}

}  // namespace rob::runtime
