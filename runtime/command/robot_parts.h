#pragma once

#include "runtime/command/assumptions.h"
#include "runtime/command/commanded_progress.h"
#include "runtime/command/device_desk.h"
#include "runtime/command/effect_queue.h"
#include "runtime/command/errand.h"
#include "runtime/command/file_desk.h"
#include "runtime/command/force_commands.h"
#include "runtime/command/guard.h"
#include "runtime/command/handler_turns.h"
#include "runtime/command/loads.h"
#include "runtime/command/motion_commands.h"
#include "runtime/command/motion_plans.h"
#include "runtime/command/motion_queue.h"
#include "runtime/command/next_motion.h"
#include "runtime/command/operator_desk.h"
#include "runtime/command/operator_stop.h"
#include "runtime/command/press_line.h"
#include "runtime/command/program_effects.h"
#include "runtime/command/readings.h"
#include "runtime/command/robot_links.h"
#include "runtime/command/safe_outputs.h"
#include "runtime/command/surroundings.h"
#include "runtime/command/task_reports.h"
#include "runtime/command/touching.h"
#include "runtime/command/waits.h"
#include "runtime/command/whens.h"

namespace rob::runtime {

/// The parts of a RobotMachine. Each part knows only parts above it in this list.
struct RobotParts {
  RobotParts(const RobotLinks& links, double override_share);
  RobotParts(const RobotParts&) = delete;

  // Commands, and how far they have come
  EffectQueue effects;
  CommandedProgress progress;
  NextMotion next;
  Guard guard;
  Whens whens;
  ProgramEffects outputs;
  // The surroundings of motions
  Assumptions assumptions;
  Surroundings surroundings;
  Loads loads;
  PressLine press;
  Touching touching;
  // Motions
  MotionPlans plans;
  MotionQueue queue;
  MotionCommands motions;
  // Between motions
  Waits waits;
  OperatorDesk desk;
  FileDesk files;
  DeviceDesk devices;
  ForceCommands forces;
  Readings readings;
  // Beside the program
  SafeOutputs safe;
  TaskReports reports;
  OperatorStop operator_stop;
  HandlerTurns turns;
  Errand errand;  ///< of the machine that handlers command
  const TaskSide task_side;
};

}  // namespace rob::runtime
