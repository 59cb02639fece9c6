#pragma once

#include <algorithm>
#include <deque>

#include "motion/dynamics/arm_load.h"

namespace rob::runtime {

/// On the program's side: the load that the arm is said to carry, and the load that was last sent
/// to motion.
/// Loads that have been sent keep their addresses for the whole run: the ticks point to them.
class LoadBook {
 public:
  /// WITH: what the tool weighs.
  void mount(const motion::ArmLoad& tool) { wanted_.tool = tool; }
  /// LOAD
  void grasp(const motion::ArmLoad& grasped) { wanted_.grasped = grasped; }

  bool news() const { return !(wanted_ == told()); }
  /// The load to send now. A program that grasps the same object again and again takes no memory.
  const motion::CarriedLoad* tell() {
    const auto known = std::ranges::find(kept_, wanted_);
    return told_ = known != kept_.end() ? &*known : &kept_.emplace_back(wanted_);
  }

  motion::CarriedLoad told() const { return told_ == nullptr ? motion::CarriedLoad{} : *told_; }
  /// The same, null for nothing.
  const motion::CarriedLoad* last() const { return told_; }

  /// Somebody else has sent a load.
  void doubt() { doubted_ = true; }
  /// The load that was sent may have been dropped, if there was one. `carried`: the load that the
  /// arm carries, null for nothing.
  void doubt_where_told(const motion::CarriedLoad* carried) {
    doubted_ = doubted_ || told_ != nullptr || carried != nullptr;
  }
  bool doubted() const { return doubted_; }
  /// `carried`: the load that the arm carries, null for nothing.
  void take_up(const motion::CarriedLoad* carried) {
    doubted_ = false;
    told_ = carried;
    wanted_.grasped = told().grasped;
    found_ = told().tool;
  }
  /// The tool is again the one that was found; it counts if no load is in doubt.
  void put_tool_back() {
    if (!doubted_) wanted_.tool = found_;
  }

 private:
  motion::CarriedLoad wanted_;
  motion::ArmLoad found_;  ///< of the tool, in the last take_up()
  const motion::CarriedLoad* told_ = nullptr;
  std::deque<motion::CarriedLoad> kept_;
  bool doubted_ = false;
};

}  // namespace rob::runtime
