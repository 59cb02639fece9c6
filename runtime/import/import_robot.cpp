#include "runtime/import/import_robot.h"

#include <fmt/format.h>

#include <filesystem>
#include <vector>

#include "base/unit_factors.h"
#include "lang/text/visible.h"
#include "motion/robots/robot_file.h"
#include "runtime/import/capsule_fit.h"
#include "runtime/import/link_bodies.h"
#include "runtime/import/robot_text.h"
#include "runtime/import/touching.h"
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

/// The values that the URDF does not say, and who knows it.
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

/// A link with its capsules, and by how much they stand out, m.
struct FittedLink {
  motion::Body link;
  double out = 0;
};

/// Base, axes of the chain, flange.
std::vector<FittedLink> fitted_links(const ImportedArm& arm, const ImportRequest& request) {
  std::vector<const RigidBody*> rigid{&arm.base};
  for (std::size_t i = 0; i < arm.chain; ++i) rigid.push_back(&arm.axes[i].body);
  rigid.push_back(&arm.tool);
  std::vector<FittedLink> fitted;
  for (const RigidBody* one : rigid) {
    const std::vector<Body> bodies = bodies_of(*one, request.urdf, request.packages);
    FittedLink made;
    made.link = {one->link, static_cast<int>(fitted.size()), fitted_capsules(bodies)};
    made.out = standing_out(made.link.shapes, bodies);
    fitted.push_back(std::move(made));
  }
  return fitted;
}

std::string link_line(const FittedLink& fitted) {
  const std::size_t count = fitted.link.shapes.size();
  const std::string name = lang::visible(fitted.link.name);
  if (count == 0) return fmt::format("    {:<24} no <collision>: it is not checked\n", name);
  return fmt::format("    {:<24} {} capsule{}, standing out by at most {:.1f} mm\n", name, count,
                     count == 1 ? "" : "s", fitted.out / kMillimetre);
}

std::string shapes_report(const std::vector<FittedLink>& links,
                          const std::vector<motion::Apart>& touching) {
  std::string text = "links, for collisions:\n";
  for (const FittedLink& fitted : links) text += link_line(fitted);
  for (const motion::Apart& pair : touching)
    text += fmt::format("never checked, for they always touch: {} and {}\n",
                        lang::visible(pair.first), lang::visible(pair.second));
  return text;
}

std::string report_of(const ImportedArm& arm, const ImportRequest& request) {
  std::string text =
      fmt::format("{}: {} axes from {} to {}\n", lang::visible(request.robot), arm.axes.size(),
                  lang::visible(arm.base.link), lang::visible(arm.tip));
  for (const ImportedAxis& axis : arm.axes) text += axis_line(axis);
  for (const std::string& joint : arm.left_out)
    text += fmt::format("left out: joint {}\n", lang::visible(joint));
  if (!arm.tools.empty()) text += "frames on the flange, as lines of a program:\n";
  for (const ImportedTool& tool : arm.tools) text += fmt::format("    {}\n", tool_line(tool));
  return text;
}

}  // namespace

ImportedRobot import_robot(const std::string& urdf, const ImportRequest& request) {
  const ImportedArm arm = find_arm(read_urdf(urdf, request.urdf), request.choice, request.urdf);
  const std::string source = std::filesystem::path(request.urdf).filename().string();
  const std::vector<FittedLink> fitted = fitted_links(arm, request);
  std::vector<motion::Body> links;
  for (const FittedLink& one : fitted) links.push_back(one.link);
  const std::vector<motion::Apart> touching = always_touching(arm, links);
  ImportedRobot made{robot_text(arm, links, touching, source),
                     report_of(arm, request) + shapes_report(fitted, touching) + to_look_up(arm)};
  static_cast<void>(motion::parse_robot_file(made.text, request.robot));
  return made;
}

}  // namespace rob::runtime
