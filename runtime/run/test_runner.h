#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lang/values/random.h"
#include "motion/robots/robot_model.h"
#include "runtime/command/program_log.h"
#include "runtime/run/load.h"
#include "runtime/run/run_result.h"
#include "runtime/time/wall_time.h"

namespace rob::runtime {

/// The result of one TEST.
struct TestResult {
  std::string name;
  lang::Place place;
  double time = 0;                       ///< s, of its run
  std::vector<FailedExpect> failures{};  ///< the first of them
  std::size_t failures_left_out = 0;
  std::optional<Problem> error{};     ///< what ended it before its end
  std::vector<std::string> output{};  ///< what PRINT wrote

  bool passed() const { return failures.empty() && !error; }
};

/// Runs every TEST of a compiled program on the virtual clock, each on a robot of its own that has
/// just been powered up, with the program's declarations executed anew and CLOCK at 0. One that
/// does not end within an hour of its time or 100,000,000 instructions has failed.
std::vector<TestResult> run_tests(const LoadedProgram& program, const motion::RobotModel& robot,
                                  std::uint64_t seed = lang::Random::kDefaultSeed,
                                  const std::string& data = "", const WallTime& date = {});

}  // namespace rob::runtime
