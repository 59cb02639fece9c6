#pragma once

#include <atomic>
#include <memory>

#include "motion/generate/paul_generator.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/plan/motion_planner.h"
#include "motion/robots/robot_model.h"
#include "motion/servo/servo_backend.h"
#include "motion/servo/servo_law.h"
#include "runtime/command/program_log.h"
#include "runtime/command/program_task.h"
#include "runtime/command/robot_machine.h"
#include "runtime/run/load.h"
#include "runtime/tick/channels.h"
#include "runtime/time/clock.h"
#include "tests/bench/outcome.h"

namespace rob::bench {

/// The organisation that S1 had first, and measured 21.60 s with, on Rob's own parts: program,
/// planner, buffer, generator, servo law and simulated gantry. Its causes of delay, as S1 found
/// them:
///
/// - both loops start their timers after their work, so that every period is longer by it;
/// - a reference is computed for one period more than the one before, however late it is;
/// - the next instruction is fetched and decoded between two periods of the generator;
/// - the servo waits by asking the time over and over, and leaves the generator what the
///   scheduler takes from it.
///
/// Both loops run at normal priority: at a fixed one, a servo that never blocks would not let the
/// generator run at all.
class FirstOrganisation {
 public:
  /// `work`: s of processor time added to each reference, servo cycle and instruction.
  explicit FirstOrganisation(double work);
  ~FirstOrganisation();
  FirstOrganisation(const FirstOrganisation&) = delete;
  FirstOrganisation& operator=(const FirstOrganisation&) = delete;

  /// The published program from start to end, in real time. Once.
  Outcome run();

 private:
  void generator_loop();
  void servo_loop();
  void fetch();
  bool finished();

  const double work_;
  motion::RobotModel robot_;
  runtime::LoadedProgram text_;
  runtime::Channels channels_;
  runtime::ProgramLog log_;
  motion::LookAheadBuffer buffer_;
  motion::MotionPlanner planner_;
  motion::PaulGenerator generator_;
  runtime::RobotMachine machine_;
  runtime::ProgramTask instructions_;
  runtime::ProgramTask::State program_state_ = runtime::ProgramTask::State::Busy;
  motion::ServoLaw law_;
  std::unique_ptr<motion::ServoBackend> gantry_;

  runtime::SystemClock clock_;
  SampleCount samples_;
  double measured_ = 0;
  std::atomic<bool> over_{false};
};

}  // namespace rob::bench
