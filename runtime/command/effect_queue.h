#pragma once

#include <cstdint>

#include "runtime/command/robot_links.h"

namespace rob::runtime {

/// The effects of a program on their way to motion, which carries them out in motion order: each
/// acts after the motion that was planned before it.
class EffectQueue {
 public:
  explicit EffectQueue(const RobotLinks& links) : links_(links) {}

  bool full() const { return links_.buffer.effects_full(); }
  /// `Later` where there is no room. `changes`: it could change what the program reads.
  lang::Reply push(motion::Effect effect, bool changes = true) {
    effect.after = links_.planner.last_number();
    effect.generation = links_.planner.generation();
    if (!links_.buffer.push(effect)) return lang::Reply::Later;
    ++pushed_;
    if (changes) changing_ = pushed_;
    return lang::Reply::Done;
  }
  /// How many since the beginning; MotionProgress::effects_done counts those that have acted.
  std::int64_t pushed() const { return pushed_; }
  /// The number of the last one that could change what is read.
  std::int64_t changing() const { return changing_; }

 private:
  const RobotLinks& links_;
  std::int64_t pushed_ = 0;
  std::int64_t changing_ = 0;
};

}  // namespace rob::runtime
