#include "runtime/import/import_robot.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/unit_factors.h"
#include "lang/text/visible.h"
#include "motion/robots/robot_file.h"
#include "runtime/import/robot_text.h"
#include "runtime/import/urdf.h"

namespace rob::runtime {

namespace {

std::string axis_line(const ImportedAxis& axis) {
  const double unit = axis.linear ? kMillimetre : kDegree;
  const char* const name = axis.linear ? "mm" : "deg";
  return fmt::format("    {:<24} {:.6g} … {:.6g} {}, {:.6g} {}/s, {}\n", axis.name, axis.min / unit,
                     axis.max / unit, name, axis.v_max / unit, name,
                     axis.effort > 0
                         ? fmt::format("{:.6g} {}", axis.effort, axis.linear ? "N" : "Nm")
                         : "no effort given");
}

/// What the URDF does not say, and who knows it.
std::string to_look_up(const ImportedArm& arm) {
  std::string text =
      "look up in the data sheet, and correct in the file, what is marked [choice]:\n"
      "    a_max, j_max of each axis: its greatest acceleration and jerk\n"
      "    inertia, friction, encoder_resolution, bandwidth, following_… of each drive\n"
      "    reference_period, servo_period: how often the arm takes commands\n"
      "    start: where the simulated arm stands at power-up\n";
  for (const ImportedAxis& axis : arm.axes) {
    if (axis.endless) text += fmt::format("    min, max of {}: it turns without end\n", axis.name);
    if (axis.effort <= 0) text += fmt::format("    force_max of {}: no effort given\n", axis.name);
  }
  return text;
}

std::string report_of(const ImportedArm& arm, const ImportRequest& request) {
  std::string text =
      fmt::format("{}: {} axes from {} to {}\n", lang::visible(request.robot), arm.axes.size(),
                  lang::visible(arm.base.link), lang::visible(arm.tip));
  for (const ImportedAxis& axis : arm.axes) text += axis_line(axis);
  for (const std::string& joint : arm.left_out)
    text += fmt::format("left out: joint {}\n", lang::visible(joint));
  return text + to_look_up(arm);
}

}  // namespace

ImportedRobot import_robot(const std::string& urdf, const ImportRequest& request) {
  const ImportedArm arm = find_arm(read_urdf(urdf, request.urdf), request.choice, request.urdf);
  const std::string source = std::filesystem::path(request.urdf).filename().string();
  ImportedRobot made{robot_text(arm, source), report_of(arm, request)};
  static_cast<void>(motion::parse_robot_file(made.text, request.robot));
  return made;
}

}  // namespace rob::runtime
