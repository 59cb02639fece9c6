#include "runtime/prompt/point_wizard.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "base/unit_factors.h"
#include "lang/values/tool_fit.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

constexpr std::size_t kOfFrame = 3;
constexpr std::size_t kLeastOfTool = 4;
constexpr std::size_t kMostOfTool = lang::kMostToolPoses;

/// 0.001 mm and 0.0001 deg: what a point has when it is saved.
std::string position_text(const lang::PoseValue& pose) {
  const lang::FixedAngles angles = lang::pose_math::to_fixed(pose.rotation);
  const auto mm = [](double metres) { return shown(metres / kMillimetre, 3) + "mm"; };
  const auto deg = [](double radians) { return shown(radians / kDegree, 4) + "deg"; };
  const lang::Vector3& at = pose.position;
  return fmt::format("POSE({}, {}, {}, {}, {}, {})", mm(at.x), mm(at.y), mm(at.z), deg(angles.a),
                     deg(angles.b), deg(angles.c));
}

}  // namespace

bool PointWizard::enough() const {
  return flanges_.size() >= (makes_ == Makes::Frame ? kOfFrame : kLeastOfTool);
}

bool PointWizard::full() const {
  return flanges_.size() >= (makes_ == Makes::Frame ? kOfFrame : kMostOfTool);
}

std::string PointWizard::question() const {
  if (full()) return fmt::format("Enter writes {}, :stop leaves", name_);
  if (makes_ == Makes::Frame) {
    static constexpr std::array kPlaces{"its origin", "a place on its x axis",
                                        "a place in its xy plane, where y is above 0"};
    return fmt::format("{}: move to {}, then Enter; :stop leaves", name_,
                       kPlaces.at(flanges_.size()));
  }
  if (enough())
    return fmt::format("{}: {}; Enter takes another position, :done writes it, :stop leaves", name_,
                       found());
  return fmt::format(
      "{}: touch the same tip, each time turned otherwise, then Enter ({} of {}); "
      ":stop leaves",
      name_, flanges_.size() + 1, kLeastOfTool);
}

std::string PointWizard::found() const {
  const auto fit = lang::fit_tool(flanges_);
  if (!fit) return "turned by less than 10deg, or about one axis only";
  const auto mm = [](double metres, int decimals) { return shown(metres / kMillimetre, decimals); };
  return fmt::format("the tip is at ({}, {}, {}) mm from the flange, missed by {} mm",
                     mm(fit->tip.x, 2), mm(fit->tip.y, 2), mm(fit->tip.z, 2), mm(fit->miss, 3));
}

std::string PointWizard::declaration() const {
  std::vector<std::string> poses;
  for (const lang::PoseValue& flange : flanges_)
    poses.push_back(position_text(flange) + (tip_.empty() ? "" : " * " + tip_));
  const bool frame = makes_ == Makes::Frame;
  return fmt::format("{} {} = {}({})", frame ? "FRAME" : "TOOL", name_, frame ? "FRAME3" : "TOOL4",
                     fmt::join(poses, ", "));
}

}  // namespace rob::runtime
