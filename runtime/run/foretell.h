#pragma once

#include <cstdint>
#include <functional>

#include "lang/values/random.h"
#include "motion/ahead/path_listener.h"
#include "motion/robots/robot_model.h"
#include "runtime/files/signal_script.h"
#include "runtime/run/load.h"
#include "runtime/run/run_result.h"
#include "runtime/tick/channels.h"
#include "runtime/time/wall_time.h"

namespace rob::runtime {

/// Under what a run is foretold.
struct ForetellOptions {
  std::uint64_t seed = lang::Random::kDefaultSeed;  ///< of RANDOM
  const SignalScript* script = nullptr;             ///< what drives the inputs, without errors
  double override_share = 1;                        ///< 1 = 100 %
  std::string data{};                               ///< --data, or empty
  motion::PathListener* path = nullptr;             ///< gets the path, under the look-ahead law
  /// s of the program's time for which it is followed: for at most 100,000,000 instructions an
  /// hour, where a shorter time counts as an hour.
  double longest = 3600;
  /// Motions that are foretold to end early will do so in the run: its inputs are simulated.
  bool ends_known = true;
  WallTime date{};                                      ///< when it begins
  std::function<void(double time)> progress{};          ///< in every cycle: how far it is, s
  std::function<void(const Snapshot& snapshot)> row{};  ///< a reference period, for pictures
  /// A motion begins that was programmed to go there.
  std::function<void(const motion::JointVector& target, int line)> target{};
};

/// Runs a program in virtual time to learn what it will do: per line start, duration, decision
/// point and corner miss, and all findings. Nothing moves and nothing is printed; a program that
/// does not end is given up after ForetellOptions::longest, with a finding that says so.
RunResult foretell(const LoadedProgram& program, const motion::RobotModel& robot,
                   const ForetellOptions& options = {});

}  // namespace rob::runtime
