#pragma once

#include <optional>
#include <utility>

#include "motion/generate/rest.h"
#include "runtime/command/program_watch.h"
#include "runtime/command/robot_links.h"

namespace rob::runtime {

/// A condition that ends a motion early: UNTIL, or at a prompt the key that is held for a jog. It
/// is on from the command before the motion until its end is known.
class Guard {
 public:
  explicit Guard(const RobotLinks& links) : until_(links.signature.signals, links.robot) {}

  void set(const lang::Watch& condition) {
    until_.set(condition);
    on_ = true;
  }
  /// This guards all that is queued until release(), in place of an UNTIL.
  void hold(const motion::Watch& held) {
    held_ = held;
    on_ = true;
  }
  void release(bool on) {
    on_ = on;
    held_ = {};
  }
  void put_on(motion::SegmentDescriptor& segment) const {
    if (on_) segment.guard = held_.present() ? held_ : until_.handle();
  }
  bool on() const { return on_; }
  void switch_to(bool on) { on_ = on; }
  bool switch_off() { return std::exchange(on_, false); }
  /// Why the UNTIL could not be computed.
  lang::ArithmeticError error() const { return until_.error(); }

  /// Where the last guarded motion was hit, or ended, m, rad.
  const motion::JointVector& hit() const { return hit_; }
  void set_hit(const motion::JointVector& q) { hit_ = q; }

  /// A handler has ended the guarded motion by leaving its path.
  void leave(const motion::Rest& rest) { left_ = rest; }
  void forget_left() { left_.reset(); }
  std::optional<motion::Rest> take_left() { return std::exchange(left_, std::nullopt); }

 private:
  ProgramWatch until_;
  motion::Watch held_;
  bool on_ = false;
  motion::JointVector hit_;
  std::optional<motion::Rest> left_;
};

}  // namespace rob::runtime
