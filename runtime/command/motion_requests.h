#pragma once

#include "lang/machine/move_command.h"
#include "motion/plan/motion_request.h"

/// From the language's words for a motion to motion's own. SI.
namespace rob::runtime {

/// The MotionRequest of a MOVE; the source line is its tag.
motion::MotionRequest request_of(int line, const lang::MoveCommand& command);

}  // namespace rob::runtime
