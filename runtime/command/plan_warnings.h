#pragma once

#include "motion/plan/planned_segment.h"
#include "runtime/command/commanded.h"
#include "runtime/command/program_log.h"

namespace rob::runtime {

/// Reports where a motion has not become what the program asks for. `before`: line of the motion
/// before it.
void report_warnings(ProgramLog& log, const motion::RobotModel& robot, int before, int line,
                     const Commanded& commanded, const motion::PlannedSegment& planned);

}  // namespace rob::runtime
