#pragma once

#include "motion/plan/planned_segment.h"
#include "runtime/command/commanded.h"
#include "runtime/command/program_log.h"

namespace rob::runtime {

/// The motion before: its line, and that of the WITH or DEFAULT which its ZONE is of; 0: its own.
struct CornerBefore {
  int line = 0;
  int zone_line = 0;
};

/// Reports where a motion has not become what the program asks for.
void report_warnings(ProgramLog& log, const motion::RobotModel& robot, CornerBefore before,
                     int line, const Commanded& commanded, const motion::PlannedSegment& planned);

}  // namespace rob::runtime
