#pragma once

#include "runtime/command/motion_queue.h"
#include "runtime/command/press_line.h"
#include "runtime/command/program_effects.h"

namespace rob::runtime {

/// PRESS, ENDPRESS and ZERO force: they begin and end while the axes stand on their path.
class ForceCommands {
 public:
  ForceCommands(const RobotLinks& links, const Surroundings& surroundings,
                const CommandedProgress& progress, ProgramEffects& effects, MotionQueue& queue,
                PressLine& press)
      : links_(links),
        surroundings_(surroundings),
        progress_(progress),
        effects_(effects),
        queue_(queue),
        press_(press) {}

  /// Done when the force has been reached.
  lang::Reply press(int line, const lang::PressCommand& command);
  lang::Reply end_press(int line);
  /// An error is settled: a PRESS that has not come to its force yet ends.
  lang::Reply give_up_press();
  lang::Reply zero_force(int line);

 private:
  lang::Reply begin_press(int line, const lang::PressCommand& command);
  lang::Reply leave_press(bool met);

  const RobotLinks& links_;
  const Surroundings& surroundings_;
  const CommandedProgress& progress_;
  ProgramEffects& effects_;
  MotionQueue& queue_;
  PressLine& press_;
};

}  // namespace rob::runtime
