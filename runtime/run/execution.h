#pragma once

#include <cstdint>
#include <functional>

#include "runtime/command/program_task.h"
#include "runtime/run/controller.h"

namespace rob::runtime {

/// How a run kept its time.
struct Timing {
  std::int64_t late_cycles = 0;  ///< reference periods that passed without a cycle
  double worst_lateness = 0;     ///< s
  double drift = 0;              ///< s that passed in the world beyond the generator's time
  bool gave_up = false;          ///< a limit of RunLimits ended it
  bool waits_for_ever = false;   ///< of these its Standstill
};

/// Where a run on the virtual clock ends by itself: what foretells must not run for ever.
struct RunLimits {
  double virtual_time;  ///< s
  std::int64_t instructions;
  bool standstill = false;  ///< ends where a Standstill is for ever
};

/// s between two looks of the planner of the path. [choice] of 50 ms that it may be late at most
inline constexpr double kPlanningPeriod = 0.002;

/// Called between cycles by the thread that reports.
using Attend = std::function<void()>;

/// Steps program, motion and servo by one thread on the virtual clock, as fast as possible, to
/// the same bits every time. Returns when the robot stands and nothing is left to do.
Timing run_stepped(Controller& controller, ProgramTask& program, const RunLimits& limits,
                   const Attend& attend);

/// The same objects in real time, each task on a thread of its own.
Timing run_threaded(Controller& controller, ProgramTask& program, const Attend& attend);

}  // namespace rob::runtime
