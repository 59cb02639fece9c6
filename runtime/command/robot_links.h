#pragma once

#include <cstddef>
#include <functional>

#include "lang/machine/machine.h"
#include "lang/machine/robot_signature.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_model.h"
#include "runtime/command/program_log.h"
#include "runtime/tick/channels.h"
#include "runtime/words/messages.h"

namespace rob::runtime {

/// Refuses the current command for this reason; Refused.
using Refuse = std::function<lang::Reply(Words)>;

/// The collaborators of the program's side of a robot. Others own them, and they outlive that side.
struct RobotLinks {
  const motion::RobotModel& robot;
  const lang::RobotSignature& signature;
  motion::MotionPlanner& planner;
  motion::LookAheadBuffer& buffer;
  Channels& channels;
  MotionProgress& progress;  ///< of the motions in `buffer`; one of those of `channels`
  ProgramLog& log;
  Refuse refuse;

  /// By the number that the language names.
  const lang::RobotSignature::Signal& signal(int number) const {
    return signature.signals.at(static_cast<std::size_t>(number));
  }
  /// Handlers command here, not the program.
  bool of_handlers() const { return &progress == &channels.handler; }
};

}  // namespace rob::runtime
