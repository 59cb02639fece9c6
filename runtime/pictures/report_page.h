#pragma once

#include <cstdint>
#include <string>

#include "motion/robots/robot_model.h"
#include "runtime/pictures/run_curves.h"
#include "runtime/run/run_result.h"

namespace rob::runtime {

/// A report says this besides the result.
struct ReportAbout {
  bool measured = false;   ///< the program ran; else it was foretold
  std::uint64_t seed = 0;  ///< of RANDOM
  std::string source{};    ///< of the program
  std::string version{};   ///< of Rob
};

/// The page of `--report` (docs/cli.md): one HTML file that needs no other and no network. It
/// contains the document of `--json`, a table of the lines, the way of the flange, and curves.
std::string report_page(const RunResult& result, const motion::RobotModel& robot,
                        const RunCurves& curves, const ReportAbout& about);

}  // namespace rob::runtime
