#pragma once

#include "lang/machine/move_command.h"
#include "motion/plan/motion_request.h"

/// What the language asks of a motion, in motion's own terms. SI.
namespace rob::runtime {

motion::MotionRequest::Pace pace_of(lang::MoveCommand::Pace pace);

/// The MotionRequest of a MOVE; the source line is its tag.
motion::MotionRequest request_of(int line, const lang::MoveCommand& command);

}  // namespace rob::runtime
