#pragma once

#include "motion/generate/trajectory_generator.h"

namespace rob::runtime {

/// "running": what motion does, for people.
constexpr const char* state_name(motion::MotionState state) {
  switch (state) {
    case motion::MotionState::Idle:
      return "idle";
    case motion::MotionState::Running:
      return "running";
    case motion::MotionState::Held:
      return "held";
    case motion::MotionState::Stopping:
      return "stopping";
    case motion::MotionState::Jogging:
      return "jogging";
    case motion::MotionState::Pressing:
      return "pressing";
  }
  return "";
}

}  // namespace rob::runtime
