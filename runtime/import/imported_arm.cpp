#include "runtime/import/imported_arm.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>

#include "base/unit_factors.h"
#include "lang/text/suggest.h"
#include "lang/text/visible.h"
#include "motion/robots/robot_file_error.h"
#include "motion/space/joint_vector.h"
#include "runtime/import/program_name.h"

namespace rob::runtime {

namespace {

constexpr double kEndless =
    10 * kFullTurn;                  // [choice] an endless axis may turn so far to each side
constexpr double kLeastAxis = 1e-6;  // [choice] a shorter vector has no direction
// What a robot file allows.
constexpr double kMostAngle = 1000;   // rad
constexpr double kMostLength = 100;   // m
constexpr double kMostPlace = 10;     // m, from axis to axis
constexpr double kMostTurning = 100;  // rad/s
constexpr double kMostSliding = 10;   // m/s
constexpr double kLeastSpeed = 1e-6;

bool moves(const UrdfJoint& joint) { return joint.kind != UrdfJoint::Kind::Fixed; }

/// The frame of the joint turned so that its axis is z: seen from it the joint's own frame.
Eigen::Quaterniond onto_z(const UrdfJoint& joint) {
  const Eigen::Vector3d axis = joint.axis.normalized();
  if (axis.z() < -1 + 1e-12)
    return Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis);
}

/// Builds the arm step by step: the way from base to tip, the axes on it, the bodies they carry.
class ArmFinder {
 public:
  ArmFinder(const Urdf& urdf, const ArmChoice& choice, const std::string& file)
      : urdf_(urdf), choice_(choice), file_(file) {}

  ImportedArm find() {
    arm_.base.link = chosen_link(choice_.base, "base", urdf_.root);
    arm_.tip = choice_.tip.empty() ? only_leaf() : chosen_link(choice_.tip, "tip", "");
    find_way();
    arm_.name = program_name(urdf_.name, "arm", {});
    make_chain();
    add_gripper();
    check_count();
    find_bodies();
    name_tools();
    return std::move(arm_);
  }

 private:
  [[noreturn]] void refuse(const std::string& problem) const {
    throw motion::RobotFileError(file_ + ": " + lang::visible(problem));
  }

  template <typename Named>
  std::string meant(const std::string& word, const std::vector<Named>& among) const {
    std::vector<std::string_view> names;
    for (const Named& one : among) names.push_back(one.name);
    const std::string hint = lang::did_you_mean(lang::suggest(word, names));
    return hint.empty() ? fmt::format("there are {}", fmt::join(names, ", ")) : hint;
  }

  std::string chosen_link(const std::string& name, const char* what, const std::string& fallback) {
    if (name.empty()) return fallback;
    if (std::ranges::find(urdf_.links, name, &UrdfLink::name) != urdf_.links.end()) return name;
    refuse(fmt::format("there is no link {} for --{}; {}", name, what, meant(name, urdf_.links)));
  }

  /// The joints from the base down to the link, in order; false: it is not below the base.
  bool way_to(const std::string& link, std::vector<const UrdfJoint*>& way) const {
    way.clear();
    for (std::string at = link; at != arm_.base.link;) {
      const UrdfJoint* const up = urdf_.parent_of(at);
      if (up == nullptr) return false;
      way.push_back(up);
      at = up->parent;
    }
    std::ranges::reverse(way);
    return true;
  }

  std::string only_leaf() const {
    std::set<std::string> parents;
    for (const UrdfJoint& joint : urdf_.joints) parents.insert(joint.parent);
    std::vector<std::string> leaves;
    std::vector<std::string> shown;
    std::vector<const UrdfJoint*> way;
    for (const UrdfLink& link : urdf_.links) {
      if (parents.contains(link.name) || !way_to(link.name, way)) continue;
      const auto moving = std::ranges::count_if(way, [](const auto* j) { return moves(*j); });
      leaves.push_back(link.name);
      shown.push_back(
          fmt::format("{} ({} moving joint{})", link.name, moving, moving == 1 ? "" : "s"));
    }
    if (leaves.size() == 1) return leaves.front();
    refuse(fmt::format("the arm may end at several links; name one with --tip: {}",
                       fmt::join(shown, ", ")));
  }

  void find_way() {
    if (!way_to(arm_.tip, way_))
      refuse(fmt::format("link {} does not hang on link {}; name another with --tip or --base",
                         arm_.tip, arm_.base.link));
    if (std::ranges::none_of(way_, [](const auto* joint) { return moves(*joint); }))
      refuse(fmt::format("no joint moves between {} and {}; name others with --base and --tip",
                         arm_.base.link, arm_.tip));
  }

  /// Fixed joints are folded into the place of the next axis.
  void make_chain() {
    motion::Pose place;
    for (const UrdfJoint* joint : way_) {
      place = motion::composed(place, joint->place);
      if (!moves(*joint)) continue;
      if (!joint->mimics.empty())
        refuse(
            fmt::format("joint {} on the way to {} follows {}: such arms are not known; name a "
                        "link before it with --tip",
                        joint->name, arm_.tip, joint->mimics));
      ImportedAxis axis = axis_of(*joint);
      const Eigen::Quaterniond turned = onto_z(*joint);
      place.orientation = place.orientation * turned;
      check_place(place, *joint);
      axis.place = place;
      axis.body.link = joint->child;
      carriers_[joint->name] = arm_.axes.size() + 1;
      arm_.axes.push_back(std::move(axis));
      place = {Eigen::Vector3d::Zero(), turned.conjugate()};
    }
    check_place(place, *way_.back());
    arm_.flange = place;
    arm_.chain = arm_.axes.size();
  }

  void check_place(const motion::Pose& place, const UrdfJoint& joint) const {
    if (place.position.cwiseAbs().maxCoeff() > kMostPlace)
      refuse(
          fmt::format("joint {} is {:.4g} m from the one before; at most {} m are allowed: are "
                      "the origins in m?",
                      joint.name, place.position.cwiseAbs().maxCoeff(), kMostPlace));
  }

  ImportedAxis axis_of(const UrdfJoint& joint) {
    using Kind = UrdfJoint::Kind;
    if (joint.kind == Kind::Other)
      refuse(
          fmt::format("joint {} is floating or planar; an axis is revolute, continuous or "
                      "prismatic",
                      joint.name));
    if (!joint.limited)
      refuse(
          fmt::format("joint {} has no <limit>; write <limit effort=… velocity=…> from its data "
                      "sheet into the URDF",
                      joint.name));
    if (joint.axis.norm() < kLeastAxis)
      refuse(fmt::format("the <axis> of joint {} has no direction", joint.name));
    ImportedAxis axis;
    axis.joint = joint.name;
    std::vector<std::string> taken;
    for (const ImportedAxis& other : arm_.axes) taken.push_back(other.name);
    axis.name = program_name(joint.name, "axis", taken);
    axis.linear = joint.kind == Kind::Prismatic;
    axis.endless = joint.kind == Kind::Continuous;
    axis.min = axis.endless ? -kEndless : joint.lower;
    axis.max = axis.endless ? kEndless : joint.upper;
    axis.v_max = joint.velocity;
    axis.effort = joint.effort;
    check_limits(axis);
    return axis;
  }

  void check_limits(const ImportedAxis& axis) const {
    const double most = axis.linear ? kMostLength : kMostAngle;
    const char* const unit = axis.linear ? "m" : "rad";
    if (!(axis.min < axis.max))
      refuse(fmt::format("the limits of joint {} leave no way: lower is {:.6g}, upper {:.6g} {}",
                         axis.joint, axis.min, axis.max, unit));
    if (axis.min < -most || axis.max > most)
      refuse(
          fmt::format("a limit of joint {} is beyond {} {}; write the true ones, or "
                      "type=\"continuous\" if it turns without end",
                      axis.joint, most, unit));
    const double fastest = axis.linear ? kMostSliding : kMostTurning;
    if (!(axis.v_max >= kLeastSpeed && axis.v_max <= fastest))
      refuse(
          fmt::format("velocity {:.6g} of joint {} must be above 0, at most {} {}/s; write that "
                      "of its data sheet into the URDF",
                      axis.v_max, axis.joint, fastest, unit));
  }

  void add_gripper() {
    if (choice_.gripper.empty()) return;
    const UrdfJoint* const joint = urdf_.joint(choice_.gripper);
    if (joint == nullptr)
      refuse(fmt::format("there is no joint {} for --gripper; {}", choice_.gripper,
                         meant(choice_.gripper, urdf_.joints)));
    if (carriers_.contains(joint->name))
      refuse(
          fmt::format("joint {} is on the way to the tip {}: it is an axis of the arm; name a "
                      "link before it with --tip",
                      joint->name, arm_.tip));
    if (!joint->mimics.empty())
      refuse(fmt::format("joint {} follows {}; name that one with --gripper", joint->name,
                         joint->mimics));
    if (!moves(*joint)) refuse(fmt::format("joint {} is fixed: no gripper moves it", joint->name));
    arm_.axes.push_back(axis_of(*joint));
  }

  void check_count() const {
    if (arm_.axes.size() > static_cast<std::size_t>(motion::kMaxJoints))
      refuse(
          fmt::format("{} axes; at most {} are known: name links with --base and --tip between "
                      "which there are fewer",
                      arm_.axes.size(), motion::kMaxJoints));
  }

  RigidBody& body(std::size_t number, const std::string& link) {
    if (number == 0) return arm_.base;
    if (number < arm_.chain || arm_.last().body.link == link) return arm_.axes[number - 1].body;
    return arm_.tool;
  }

  void take_shapes(const UrdfLink& link, std::size_t carrier, const motion::Pose& place) {
    RigidBody& into = body(carrier, link.name);
    const motion::Pose seen =
        &into == &arm_.tool ? motion::composed(motion::inverse(arm_.flange), place) : place;
    for (UrdfShape shape : link.shapes) {
      shape.place = motion::composed(seen, shape.place);
      into.shapes.push_back(std::move(shape));
    }
  }

  /// Where the child's frame is that a joint which is no axis of the chain carries: at zero, or at
  /// the end of its way that is nearest to it.
  static motion::Pose at_rest(const UrdfJoint& joint) {
    const bool bounded =
        joint.limited && joint.lower < joint.upper && joint.kind != UrdfJoint::Kind::Continuous;
    const double value = bounded ? std::clamp(0.0, joint.lower, joint.upper) : 0.0;
    if (value == 0 || joint.axis.norm() < kLeastAxis) return joint.place;
    const Eigen::Vector3d axis = joint.axis.normalized();
    if (joint.kind == UrdfJoint::Kind::Prismatic)
      return motion::composed(joint.place, {value * axis, Eigen::Quaterniond::Identity()});
    return motion::composed(
        joint.place, {Eigen::Vector3d::Zero(), Eigen::Quaterniond(Eigen::AngleAxisd(value, axis))});
  }

  struct Hanging {
    std::string link;
    std::size_t carrier = 0;  ///< the number of the axis, from 1; 0: the base
    motion::Pose place;       ///< in the carrier's frame
    bool fixed = true;        ///< no joint moves it against that
  };

  /// From the base on, each link belongs to the axis before it.
  void find_bodies() {
    arm_.tool.link = arm_.tip == arm_.last().body.link ? "flange" : arm_.tip;
    std::multimap<std::string, const UrdfJoint*> children;
    for (const UrdfJoint& joint : urdf_.joints) children.emplace(joint.parent, &joint);
    for (std::vector<Hanging> open{{arm_.base.link, 0, {}}}; !open.empty();) {
      const Hanging at = std::move(open.back());
      open.pop_back();
      take_shapes(*std::ranges::find(urdf_.links, at.link, &UrdfLink::name), at.carrier, at.place);
      const auto [begin, end] = children.equal_range(at.link);
      take_tool(at, begin == end);
      for (auto child = begin; child != end; ++child) open.push_back(hanging(*child->second, at));
    }
  }

  Hanging hanging(const UrdfJoint& joint, const Hanging& at) {
    const auto axis = carriers_.find(joint.name);
    if (axis != carriers_.end())
      return {joint.child, axis->second, {Eigen::Vector3d::Zero(), onto_z(joint).conjugate()}};
    if (moves(joint) && joint.name != choice_.gripper)
      arm_.left_out.push_back(
          joint.name + (joint.mimics.empty() ? "" : fmt::format(" (follows {})", joint.mimics)));
    return {joint.child, at.carrier, motion::composed(at.place, at_rest(joint)),
            at.fixed && !moves(joint)};
  }

  /// A frame on the flange: a link without a body, or the last one of a row.
  void take_tool(const Hanging& at, bool last) {
    const bool on_flange = at.fixed && at.carrier == arm_.chain && at.link != arm_.tip &&
                           at.link != arm_.last().body.link;
    const bool bodiless = std::ranges::find(urdf_.links, at.link, &UrdfLink::name)->shapes.empty();
    if (!on_flange || !(last || bodiless)) return;
    arm_.tools.push_back({"", at.link, motion::composed(motion::inverse(arm_.flange), at.place)});
  }

  void name_tools() {
    const auto place = [&](const ImportedTool& tool) {
      return std::ranges::find(urdf_.links, tool.link, &UrdfLink::name) - urdf_.links.begin();
    };
    std::ranges::sort(arm_.tools, {}, place);
    std::vector<std::string> taken;
    for (ImportedTool& tool : arm_.tools) {
      tool.name = program_name(tool.link, "tool", taken);
      taken.push_back(tool.name);
    }
  }

  const Urdf& urdf_;
  const ArmChoice& choice_;
  const std::string& file_;
  ImportedArm arm_;
  std::vector<const UrdfJoint*> way_;
  std::map<std::string, std::size_t> carriers_;  ///< the axes of the chain, from 1, by their joints
};

}  // namespace

bool ImportedArm::keeps_upright() const {
  constexpr int kOfScara = 4;
  if (chain != kOfScara) return false;
  constexpr double kLevel = 1e-6;  // [choice] as exactly as URDFs are written
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < chain; ++i) {
    turn = turn * axes[i].place.orientation;
    if (1 - std::abs((turn * Eigen::Vector3d::UnitZ()).z()) > kLevel) return false;
  }
  turn = turn * flange.orientation;
  return 1 - std::abs((turn * Eigen::Vector3d::UnitZ()).z()) < kLevel;
}

ImportedArm find_arm(const Urdf& urdf, const ArmChoice& choice, const std::string& file) {
  return ArmFinder(urdf, choice, file).find();
}

}  // namespace rob::runtime
