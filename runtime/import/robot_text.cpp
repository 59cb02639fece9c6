#include "runtime/import/robot_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/unit_factors.h"
#include "lang/text/visible.h"

namespace rob::runtime {

namespace {

// [choice] Of an arm of which nothing else is known. The servo's part of them fits each other: at
// a_max and v_max a drive has 0.4 of its force left.
constexpr double kServoPeriod = 0.002;  // s
constexpr double kTimeToSpeed = 0.25;   // s to v_max
constexpr double kTimeToPull = 0.1;     // s to a_max
constexpr double kShareOfMass = 0.5;    // of the force, at a_max
constexpr double kShareOfFriction = 0.05;
constexpr double kUnknownForce = 100;  // N, Nm
constexpr double kFinestTurn = 0.001 * kDegree;
constexpr double kFinestWay = 1e-6;  // m
constexpr double kWarnTime = 0.02;   // s by which an axis may be late at v_max
constexpr double kLeastFollowing = 1e-6;
constexpr double kMostFollowing = 1;
constexpr double kMostForce = 1e7;
constexpr double kLeastForce = 1e-3;

std::string length(double metres) { return "\"" + decimal(metres / kMillimetre) + " mm\""; }
std::string angle(double radians) { return "\"" + decimal(radians / kDegree) + " deg\""; }

std::string place_text(const motion::Pose& pose) {
  const motion::FixedAngles turn = motion::fixed_angles(pose.orientation);
  const Eigen::Vector3d& at = pose.position;
  return fmt::format("place = [{}, {}, {}]\nturn = [{}, {}, {}]\n", length(at.x()), length(at.y()),
                     length(at.z()), angle(turn.a), angle(turn.b), angle(turn.c));
}

/// "12.5 deg/s" in quotation marks.
std::string way(double si, bool linear, std::string_view per = "") {
  const double shown = linear ? si / kMillimetre : si / kDegree;
  // A value far below a thousandth keeps its digits.
  const std::string number =
      std::abs(shown) < 1e-3 && shown != 0 ? fmt::format("{:.6g}", shown) : decimal(shown);
  return fmt::format("\"{} {}{}\"", number, linear ? "mm" : "deg", per);
}

std::string plain(double value) { return fmt::format("{:.6g}", value); }

std::string drive_text(const ImportedAxis& axis, double a_max) {
  const bool known = axis.effort > 0;
  const double force = known ? std::clamp(axis.effort, kLeastForce, kMostForce) : kUnknownForce;
  const char* const unit = axis.linear ? "N" : "Nm";
  const double count = std::min(axis.linear ? kFinestWay : kFinestTurn, axis.v_max * kServoPeriod);
  const double warn = std::clamp(axis.v_max * kWarnTime, kLeastFollowing, kMostFollowing);
  std::string text = "\n[axis.drive]\n";
  text += fmt::format("inertia = \"{} {}\"  # [choice] half of force_max moves it at a_max\n",
                      plain(kShareOfMass * force / a_max), axis.linear ? "kg" : "kg*m^2");
  text +=
      fmt::format("viscous_friction = \"{} {}\"  # [choice] a twentieth of force_max at v_max\n",
                  plain(kShareOfFriction * force / axis.v_max), axis.linear ? "N*s/m" : "Nm*s/rad");
  text += fmt::format("coulomb_friction = \"{} {}\"  # [choice] likewise\n",
                      plain(kShareOfFriction * force), unit);
  text += fmt::format("force_max = \"{} {}\"{}\n", plain(force), unit,
                      known ? "" : "  # [choice] the URDF gives no effort");
  text += fmt::format("encoder_resolution = {}  # [choice]\n",
                      way(std::max(count, 1e-10), axis.linear));
  text += "bandwidth = \"40 rad/s\"  # [choice] the servo law allows 0.2 / servo_period\n";
  text +=
      fmt::format("following_warn = {}  # [choice] 20 ms late at v_max\n", way(warn, axis.linear));
  return text + fmt::format("following_limit = {}  # [choice] twice as much\n",
                            way(std::min(2 * warn, kMostFollowing), axis.linear));
}

std::string point_text(const Eigen::Vector3d& point) {
  return fmt::format("[{}, {}, {}]", length(point.x()), length(point.y()), length(point.z()));
}

std::string shapes_text(const motion::Body& link, std::string_view table) {
  std::string text;
  for (const motion::Capsule& capsule : link.shapes)
    text +=
        fmt::format("\n[[{}.shape]]\nkind = \"capsule\"\nfrom = {}\nto = {}\nradius = {}\n", table,
                    point_text(capsule.from), point_text(capsule.to), length(capsule.radius));
  return text;
}

std::string link_text(const motion::Body& link, std::string_view table) {
  return fmt::format("\n[{}]\nlink = {}\n", table, toml_text(link.name)) + shapes_text(link, table);
}

/// `link`: what it carries; null: it is none of the chain's.
std::string axis_text(const ImportedAxis& axis, const motion::Body* link) {
  const double start = axis.min <= 0 && axis.max >= 0 ? 0 : (axis.min + axis.max) / 2;
  const double a_max = axis.v_max / kTimeToSpeed;
  const char* const chosen = axis.endless ? "  # [choice] it turns without end" : "";
  std::string text = fmt::format("\n[[axis]]  # joint {} of the URDF\n", lang::visible(axis.joint));
  text +=
      fmt::format("name = \"{}\"\nkind = \"{}\"\n", axis.name, axis.linear ? "linear" : "rotary");
  text += fmt::format("min = {}{}\n", way(axis.min, axis.linear), chosen);
  text += fmt::format("max = {}{}\n", way(axis.max, axis.linear), chosen);
  text += fmt::format("start = {}  # [choice]\n", way(start, axis.linear));
  text += fmt::format("v_max = {}\n", way(axis.v_max, axis.linear, "/s"));
  text +=
      fmt::format("a_max = {}  # [choice] at v_max in 0.25 s\n", way(a_max, axis.linear, "/s^2"));
  text += fmt::format("j_max = {}  # [choice] at a_max in 0.1 s\n",
                      way(a_max / kTimeToPull, axis.linear, "/s^3"));
  if (link != nullptr) text += fmt::format("link = {}\n", toml_text(link->name));
  if (link != nullptr) text += "\n[axis.joint]\n" + place_text(axis.place);
  text += drive_text(axis, a_max);
  return link != nullptr ? text + shapes_text(*link, "axis") : text;
}

std::string head_text(const ImportedArm& arm, std::string_view source) {
  std::string text = fmt::format(
      "# The arm of {}, from {} to {}, as `rob robot import` reads it.\n"
      "#\n"
      "# Places, turns, limits, speeds and forces are those of the URDF. What a URDF does not "
      "have\n"
      "# is marked [choice]: look it up in the data sheet before a real arm moves by this file.\n"
      "# Every key is described in docs/adding-a-robot.md.\n",
      lang::visible(source), lang::visible(arm.base.link), lang::visible(arm.tip));
  for (const std::string& joint : arm.left_out)
    text += fmt::format("# Joint {} is left out: it is no axis here.\n", lang::visible(joint));
  if (!arm.tools.empty()) text += "#\n# Frames on the flange, as lines of a program:\n";
  for (const ImportedTool& tool : arm.tools) text += fmt::format("#   {}\n", tool_line(tool));
  text += fmt::format("\nname = \"{}\"\ndescription = {}\nkinematics = \"chain\"\n", arm.name,
                      toml_text(fmt::format("{} axes, imported from {}", arm.axes.size(), source)));
  if (arm.leaves_c()) text += "free = \"c\"  # five axes: the place decides c\n";
  if (arm.keeps_upright()) text += "free = \"ab\"  # its tool always points the same way\n";
  return text +
         "law = \"lookahead\"\n"
         "reference_period = \"4 ms\"  # [choice]\n"
         "servo_period = \"2 ms\"  # [choice]\n"
         "look_ahead = 64  # [choice] more than any pause of a program\n";
}

}  // namespace

std::string decimal(double value) {
  const double rounded = std::round(value * 1e6) / 1e6;
  // Of 1.57079632679 rad is left 89.9999999997 deg.
  const bool noise = std::abs(value - rounded) < 5e-10;
  std::string text = fmt::format("{:.{}f}", noise ? rounded : value, noise ? 6 : 12);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string toml_text(std::string_view text) {
  std::string made = "\"";
  for (const char c : lang::visible(text)) {
    if (c == '"' || c == '\\') made += '\\';
    made += c;
  }
  return made + "\"";
}

std::string tool_line(const ImportedTool& tool) {
  const motion::FixedAngles turn = motion::fixed_angles(tool.place.orientation);
  const Eigen::Vector3d& at = tool.place.position;
  const auto mm = [](double metres) { return decimal(metres / kMillimetre); };
  const auto deg = [](double radians) { return decimal(radians / kDegree); };
  return fmt::format("TOOL {} = POSE({}mm, {}mm, {}mm, {}deg, {}deg, {}deg)", tool.name, mm(at.x()),
                     mm(at.y()), mm(at.z()), deg(turn.a), deg(turn.b), deg(turn.c));
}

std::string robot_text(const ImportedArm& arm, const std::vector<motion::Body>& links,
                       const std::vector<motion::Apart>& touching, std::string_view source) {
  std::string text = head_text(arm, source);
  text += fmt::format("\n[chain]  # link {} of the URDF\n", lang::visible(arm.tip)) +
          place_text(arm.flange);
  if (arm.has_gripper()) text += fmt::format("\n[gripper]\naxis = \"{}\"\n", arm.axes.back().name);
  text += link_text(links.front(), "base") + link_text(links.back(), "flange");
  for (std::size_t i = 0; i < arm.axes.size(); ++i)
    text += axis_text(arm.axes[i], i < arm.chain ? &links[i + 1] : nullptr);
  if (!touching.empty())
    text +=
        "\n# In all of 10,000 postures within the limits these links are closer than 1 mm: they "
        "are\n"
        "# never checked against each other.\n";
  for (const motion::Apart& pair : touching)
    text += fmt::format("[[apart]]\nfirst = {}\nsecond = {}\n", toml_text(pair.first),
                        toml_text(pair.second));
  return text;
}

}  // namespace rob::runtime
