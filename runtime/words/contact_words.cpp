#include "runtime/words/contact_words.h"

#include <fmt/format.h>

#include <cmath>

#include "runtime/words/codes.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

/// "JOINTS(0deg, -90deg, …)": as the program would write it.
std::string joints_words(const motion::RobotModel& robot, const motion::JointVector& q) {
  std::string text;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const motion::AxisKind kind = axis_of(robot, i).kind;
    text += fmt::format("{}{}{}", i == 0 ? "" : ", ", shown(q[i] * shown_per_si(kind), 2),
                        unit_name(kind));
  }
  return "JOINTS(" + text + ")";
}

}  // namespace

std::string near_words(const std::string& body, const std::string& other, double distance) {
  const std::string millimetres = shown(std::abs(distance) * kMillimetresPerMetre, 1);
  if (distance < 0)
    return fmt::format("{} leaves {}, which it touches: {} mm deep", body, other, millimetres);
  return fmt::format("{} passes {} at a distance of {} mm", body, other, millimetres);
}

Words words_for(const Contact& contact, const motion::RobotModel& robot) {
  const std::string where = joints_words(robot, contact.q);
  if (contact.from_start)
    return {code::kBeginsInContact,
            fmt::format("{} touches {} where the motion begins, and would be pressed on at {}",
                        contact.body, contact.other, where),
            "move away from it first: a way on which they part is allowed"};
  if (contact.corner)
    return {code::kHits,
            fmt::format("{} hits {} in the corner that leads into line {}, at {}", contact.body,
                        contact.other, lang::tagged_place(contact.line).line, where),
            "a smaller ZONE or FINE at the target before keeps the corner away from it"};
  const std::string when = contact.at > 0
                               ? fmt::format("{} s after the start", shown(contact.at, 2))
                               : fmt::format("after {:.0f} % of the way", 100 * contact.share);
  return {code::kHits,
          fmt::format("{} hits {} {} of line {}, at {}", contact.body, contact.other, when,
                      lang::tagged_place(contact.line).line, where),
          "go round it by other points; where touching is the task, ALLOW … DO says so"};
}

}  // namespace rob::runtime
