#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "lang/values/random.h"
#include "motion/generate/trajectory_generator.h"
#include "motion/robots/robot_model.h"
#include "runtime/command/program_log.h"
#include "runtime/files/signal_script.h"
#include "runtime/run/load.h"
#include "runtime/run/machine.h"
#include "runtime/run/program_stores.h"
#include "runtime/run/run_result.h"
#include "runtime/tick/channels.h"
#include "runtime/tick/operator_panel.h"
#include "runtime/time/wall_time.h"

namespace rob::runtime {

/// The result of foretell() for a run that comes later.
struct Foretold {
  double planned = 0;                            ///< s
  std::size_t count = 0;                         ///< of its lines
  LineTotals lines{};                            ///< as LineTotals::expect() leaves them
  std::shared_ptr<const ClearedWays> cleared{};  ///< as in RunResult
};
Foretold foretold_by(RunResult result);

/// Says how a program runs.
struct RunOptions {
  bool fast = false;                                ///< on the virtual clock
  double override_share = 1;                        ///< 1 = 100 %
  std::string trace;                                ///< file, or empty
  std::uint64_t seed = lang::Random::kDefaultSeed;  ///< of RANDOM
  const SignalScript* script = nullptr;             ///< what drives the inputs, without errors
  std::string data{};                               ///< --data, or empty
  Person* person = nullptr;                         ///< who can answer HALT and ASK
  /// Under the look-ahead law, where times are known of whole paths alone, what is planned is what
  /// foretell() says for the same override; without it (null) the run is foretold first.
  /// It is used up.
  Foretold* foretold = nullptr;
  std::optional<WallTime> date{};  ///< when it begins; without it now, or that of the virtual clock
};

/// How far a run is: source line, s, what motion is doing.
struct Position {
  int line = 0;
  double time = 0;
  motion::MotionState state = motion::MotionState::Idle;
};

/// The reports of a run while it goes on; each may be empty.
struct RunListener {
  std::function<void(const std::string& text)> print;  ///< a line of PRINT, in motion order
  std::function<void(const Position& position)> progress;
  std::function<void(const std::string& message)> warn;       ///< a line for the user about the run
  std::function<void(const Note& note, int line)> consult{};  ///< see RunRecorder::Listener
  std::function<void(const Snapshot& snapshot)> row{};        ///< a reference period, for pictures
  std::function<void(const SignalChange& change)> signal{};   ///< see RunRecorder::Listener
  std::function<void(const std::string& text, double time, int line)> said{};  ///< the same
  std::function<bool()> abandoned{};  ///< nobody waits for the results: the run stops on its path
};

/// Runs a compiled program on an open machine, in real time or, if it is the simulation, on the
/// virtual clock. `stores` are open before the machine is, so that a value or a device that cannot
/// be had refuses the start before anything homes. Ctrl-C and the other signals of Interruption
/// stop it on its path. Throws FileError before anything moves.
RunResult run(const LoadedProgram& program, OpenMachine machine, ProgramStores& stores,
              const RunOptions& options, const RunListener& listener);
/// The same on the simulation of this robot.
RunResult run(const LoadedProgram& program, const motion::RobotModel& robot,
              const RunOptions& options, const RunListener& listener);

/// The result of a program that does not compile.
RunResult refused(const LoadedProgram& program, const motion::RobotModel& robot);
/// The result of a program that would hit something, as foretell() has found: nothing has moved.
RunResult refused_for_contact(const LoadedProgram& program, const RunResult& foretold);
/// The result of a program whose signal script has errors.
RunResult refused(const SignalScript& script, const motion::RobotModel& robot);

}  // namespace rob::runtime
