#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lang/code/chunk.h"
#include "lang/text/diagnostic.h"
#include "motion/robots/robot_model.h"
#include "runtime/tick/simulated_inputs.h"

namespace rob::runtime {

/// The content of a signal script (--signals FILE, docs/cli.md): what the simulated inputs do, and
/// what the operator does. One rule a line:
///
///     at 2.5s part_here = ON
///     when vacuum == ON after 0.3s : vac_ok = ON
///     at 4s GO = ON
///     at 5s ANSWER = "7"
///     at 6s HOLD = ON
///     at 7s OVERRIDE = 30%
///     at 8s scale = "12.5 g"
///     when lift_up == ON after 0.3s : scale = "12.5 g"
struct SignalScript {
  std::string file;
  std::string source;
  std::vector<SimulationRule> rules;
  /// The lines that a DEVICE sends, by its number.
  struct Line {
    std::size_t device = 0;
    double time = 0;  ///< s
    std::string text;
  };
  std::vector<Line> lines;  ///< of `at`
  std::vector<Line> said;   ///< of `when`, by SimulatedSetting::answer; their times say nothing
  std::vector<std::string> answers;  ///< texts of ANSWER, by SimulatedSetting::answer
  lang::Diagnostics diagnostics;     ///< all errors of the script; with one it must not be used
};

/// Reads a script for a program on a robot: it may use the program's SIGNALs, the robot's names and
/// the channels themselves.
SignalScript parse_signal_script(std::string file, std::string source,
                                 const motion::RobotModel& robot,
                                 const std::vector<lang::NamedSignal>& named,
                                 const std::vector<lang::DeviceCode>& devices = {});

}  // namespace rob::runtime
