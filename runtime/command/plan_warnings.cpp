#include "runtime/command/plan_warnings.h"

#include <string>

#include <fmt/format.h>

#include "runtime/words/codes.h"
#include "runtime/words/messages.h"
#include "runtime/words/path_words.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

/// The two lines that a corner belongs to.
std::string meeting(int one, int other) {
  const std::uint32_t first = lang::tagged_place(one).line;
  const std::uint32_t second = lang::tagged_place(other).line;
  return first == second ? fmt::format("two motions of line {}, which meet here,", first)
                         : fmt::format("lines {} and {}, which meet here,", first, second);
}

}  // namespace

void report_warnings(ProgramLog& log, const motion::RobotModel& robot, int before, int line,
                     const Commanded& commanded, const motion::PlannedSegment& planned) {
  const lang::Place place = lang::tagged_place(line);
  const bool angle = commanded.move && commanded.move->zone_angle > 0 && !commanded.move->exact();
  if (angle && robot.law == motion::Law::Paul) {
    log.found({lang::Severity::Warning, code::kZoneAngleUnused, place,
               "under Paul's law the angle of a ZONE bounds nothing",
               "leave it out, or write LAW LOOKAHEAD"});
  }
  if ((planned.warnings & motion::PlannedSegment::kPaceCut) != 0) {
    const Words words = words_for_pace_cut(planned.pace_cut, robot);
    log.found({lang::Severity::Warning, words.code, place, words.message, words.help});
  }
  if ((planned.warnings & motion::PlannedSegment::kStretched) != 0) {
    log.found({lang::Severity::Warning, code::kTooShort, place,
               fmt::format("OVER is too short: this motion takes {}{} s",
                           robot.law == motion::Law::Paul ? "" : "at least ",
                           shown(planned.segment.duration, 3)),
               "OVER is a lower bound; the axes and the corners need longer here"});
  }
  if ((planned.warnings & motion::PlannedSegment::kBoundCut) != 0) {
    log.found({lang::Severity::Warning, code::kBoundCut, place,
               "ACCEL or JERK asks for more than the axes can do",
               "the motion is as quick as its axes permit"});
  }
  if ((planned.warnings & motion::PlannedSegment::kZoneCut) != 0) {
    log.found({lang::Severity::Warning, code::kZoneCut,
               lang::tagged_place(static_cast<int>(planned.zone_tag)),
               fmt::format("ZONE cannot be used in full: {} are too short for it, and leave {} at"
                           " most, and what a bound on jerk adds to that",
                           meeting(static_cast<int>(planned.zone_tag), line),
                           shown(planned.zone_left, motion::AxisKind::Linear)),
               "a ZONE of that size says so in the program"});
  }
  if ((planned.warnings & motion::PlannedSegment::kZoneRaised) != 0) {
    log.found({lang::Severity::Warning, code::kZoneRaised, place,
               fmt::format("ZONE asks for a tighter corner than the axes can take; it becomes"
                           " ZONE {}s",
                           shown(planned.segment.t_acc, 3)),
               "FINE reaches the target exactly"});
  }
  if ((planned.warnings & motion::PlannedSegment::kCornerExact) != 0) {
    log.found({lang::Severity::Warning, code::kCornerExact, place,
               fmt::format("{} have no corner within what the axes can do: the target between them"
                           " is reached exactly",
                           meeting(before, line)),
               "FINE at that target says so; a slower AT or a greater ZONE leaves room for it"});
  }
}

}  // namespace rob::runtime
