#pragma once

#include <cstdint>

#include "lang/machine/move_command.h"
#include "lang/machine/robot_signature.h"
#include "motion/space/joint_vector.h"

namespace rob::runtime {

/// The gripper axes that a target names. They do not change the place of the tool.
class GripperElements {
 public:
  GripperElements(const lang::MoveCommand& command, const lang::RobotSignature& robot);

  bool any() const { return given_ != 0; }
  /// The target names nothing else.
  bool alone() const { return alone_; }
  /// A command to these axes alone; the others keep their targets.
  lang::MoveCommand command() const;
  /// Adds them to a target of all axes; `last`: the last one.
  void add_to(lang::MoveCommand& axes, const motion::JointVector& last) const;

 private:
  lang::MoveCommand asked_;
  int axes_;
  int shift_;               ///< from the numbers of elements to those of axes
  std::uint8_t given_ = 0;  ///< by axis
  bool alone_ = false;
};

}  // namespace rob::runtime
