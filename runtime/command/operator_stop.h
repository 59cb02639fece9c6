#pragma once

#include "lang/vm/vm.h"
#include "motion/plan/watched_action.h"
#include "runtime/command/effect_queue.h"

namespace rob::runtime {

/// At a prompt: the operator's request to stop (Channels::stop_requested) acts as a WHEN that
/// raises, and the robot stays under control after the end of a program.
class OperatorStop {
 public:
  OperatorStop(const RobotLinks& links, EffectQueue& effects) : links_(links), effects_(effects) {}

  /// From here on; before anything else is commanded.
  void stay();
  bool stays() const { return stays_; }
  /// Whether it is what has ended the motion.
  bool caused(const motion::Rest& rest) const { return rest.by == &stopping_; }
  /// Its error; the next request is one of its own.
  lang::RuntimeError take_error();

 private:
  const RobotLinks& links_;
  EffectQueue& effects_;
  bool stays_ = false;
  motion::WatchedAction stopping_;
};

}  // namespace rob::runtime
