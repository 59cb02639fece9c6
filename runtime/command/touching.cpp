#include "runtime/command/touching.h"

#include <algorithm>
#include <string>
#include <utility>

#include "motion/robots/robot_clearance.h"
#include "runtime/words/pose_values.h"

namespace rob::runtime {

namespace {

constexpr std::size_t kMostKnown = 16;  // [choice] a program changes between a few tools
const std::string kGripper = "gripper";

}  // namespace

void Touching::add(const std::vector<motion::Obstacle>& obstacles) {
  if (obstacles.empty()) return;
  for (const motion::Obstacle& obstacle : obstacles) {
    std::erase_if(data_.obstacles,
                  [&](const motion::Obstacle& earlier) { return earlier.name == obstacle.name; });
    data_.obstacles.push_back(obstacle);
  }
  known_.clear();
}

Touching::Shared Touching::in(const lang::Setting& setting) {
  static const std::vector<std::string> kNone;
  const std::vector<std::string>& allowed = setting.allowed ? *setting.allowed : kNone;
  const auto found = std::ranges::find_if(known_, [&](const Known& one) {
    return one.shape == setting.tool.shape && one.allowed == allowed;
  });
  if (found != known_.end()) return found->clearance;
  if (known_.size() == kMostKnown) known_.erase(known_.begin());
  Known& known = known_.emplace_back(Known{setting.tool.shape, allowed, {}});
  known.clearance = made(known);
  return known.clearance;
}

/// The gripper is what is fixed to the flange: what the robot's file says of it, and the tool.
Touching::Shared Touching::made(const Known& what) const {
  motion::CollisionData data = data_;
  data.allowed = what.allowed;
  const int flange = robot_.axis_count() + 1;
  if (std::ranges::find(data.allowed, kGripper) != data.allowed.end())
    for (const motion::Body& body : data.bodies)
      if (body.frame == flange) data.allowed.push_back(body.name);
  motion::Body tool{kGripper, flange, {}};
  for (const lang::CapsuleValue& one : what.shape)
    if (one.radius > 0) tool.shapes.push_back({eigen_of(one.from), eigen_of(one.to), one.radius});
  if (!tool.shapes.empty()) data.bodies.push_back(std::move(tool));
  return std::make_shared<const motion::Clearance>(motion::clearance_of(robot_, std::move(data)));
}

}  // namespace rob::runtime
