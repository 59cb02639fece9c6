#pragma once

#include <cstdint>
#include <string_view>

#include "runtime/command/effect_queue.h"
#include "runtime/command/next_motion.h"
#include "runtime/command/robot_links.h"
#include "runtime/command/whens.h"

namespace rob::runtime {

/// All that a program sets, pulses, prints, and simulates in a TEST: each becomes an effect in
/// motion order, or part of the motion or the WHEN that it was written for.
class ProgramEffects {
 public:
  /// `override_share`: the speed that the program's OVERRIDE is a share of, 1 = as programmed.
  ProgramEffects(const RobotLinks& links, EffectQueue& effects, NextMotion& next, Whens& whens,
                 double override_share);

  bool full() const { return effects_.full(); }
  /// `changes`: it could change what the program reads.
  lang::Reply queue(const motion::Effect& effect, bool changes = true);
  /// A text of the program.
  lang::Reply note(int line, Note note);
  lang::Reply write_signal(int line, int signal, bool value);
  lang::Reply write_analog(int line, int signal, double volts);
  lang::Reply pulse(int line, int signal, double seconds);
  lang::Reply override_speed(int line, double share);

  lang::Reply simulate(int line, int signal, double value, double after);
  /// `frame`: what the component is along, in the world.
  lang::Reply simulate_force(int line, int component, const motion::Pose& frame, double value,
                             double after);
  lang::Reply simulate_go(int line, double after);
  lang::Reply simulate_answer(int line, std::string_view text, double after);

 private:
  lang::Reply queue_simulation(int line, motion::Effect effect);

  const RobotLinks& links_;
  EffectQueue& effects_;
  NextMotion& next_;
  Whens& whens_;
  double operators_override_;
  std::int64_t simulations_ = 0;  ///< queued so far
};

}  // namespace rob::runtime
