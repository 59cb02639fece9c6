#pragma once

#include "lang/values/setting.h"
#include "runtime/command/axis_targets.h"
#include "runtime/command/robot_links.h"
#include "runtime/words/pose_values.h"

namespace rob::runtime {

/// WITH and IN at the program's current place: the tool and the frame that poses mean.
class Surroundings {
 public:
  explicit Surroundings(const RobotLinks& links) : links_(links) {}

  void work_in(const lang::Setting& setting) {
    setting_ = setting;
    links_.planner.set_tool(to_motion(setting.tool.tip));
  }
  const lang::Setting& setting() const { return setting_; }
  /// Where the axis values bring the tip.
  lang::PoseValue tool_at(const motion::JointVector& q) const {
    return runtime::tool_at(links_.robot, q, setting_);
  }
  /// The frame that IN has named, in the world; of the tool as it is commanded to stand.
  motion::Pose frame() const {
    return to_motion(setting_.in_tool ? tool_at(links_.planner.commanded()) : setting_.frame);
  }

 private:
  const RobotLinks& links_;
  lang::Setting setting_;
};

}  // namespace rob::runtime
