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

/// Where a warning of a clause stands: once at the WITH or DEFAULT (`given`, a line) that the
/// clause is of, else at its motion.
struct ClausePlace {
  ClausePlace(int given, int line)
      : place(lang::tagged_place(given != 0 ? given : line)),
        first(given != 0 ? fmt::format(", first in line {}", lang::tagged_place(line).line) : "") {}
  lang::Place place;
  std::string first;
};

}  // namespace

void report_warnings(ProgramLog& log, const motion::RobotModel& robot, CornerBefore before,
                     int line, const Commanded& commanded, const motion::PlannedSegment& planned) {
  const lang::Place place = lang::tagged_place(line);
  const lang::MoveCommand own;
  const lang::MoveCommand& move = commanded.move ? *commanded.move : own;
  const bool angle = move.zone_angle > 0 && !move.exact();
  if (angle && robot.law == motion::Law::Paul) {
    log.found({lang::Severity::Warning, code::kZoneAngleUnused,
               ClausePlace(move.zone_line, line).place,
               "under Paul's law the angle of a ZONE bounds nothing",
               "leave it out, or write LAW LOOKAHEAD"});
  }
  if ((planned.warnings & motion::PlannedSegment::kPaceCut) != 0) {
    const Words words = words_for_pace_cut(planned.pace_cut, robot);
    const ClausePlace at(move.pace_line, line);
    log.found(
        {lang::Severity::Warning, words.code, at.place, words.message + at.first, words.help});
  }
  if ((planned.warnings & motion::PlannedSegment::kStretched) != 0) {
    log.found({lang::Severity::Warning, code::kTooShort, place,
               fmt::format("OVER is too short: this motion takes {}{} s",
                           robot.law == motion::Law::Paul ? "" : "at least ",
                           shown(planned.segment.duration, 3)),
               "OVER is a lower bound; the axes and the corners need longer here"});
  }
  if ((planned.warnings & motion::PlannedSegment::kBoundCut) != 0) {
    const bool jerk = move.jerk != lang::MoveCommand::Bound::Unspecified;
    const ClausePlace at(jerk ? 0 : move.accel_line, line);
    log.found({lang::Severity::Warning, code::kBoundCut, at.place,
               "ACCEL or JERK asks for more than the axes can do" + at.first,
               "the motion is as quick as its axes permit"});
  }
  if ((planned.warnings & motion::PlannedSegment::kZoneCut) != 0) {
    const int zoned = static_cast<int>(planned.zone_tag);
    log.found(
        {lang::Severity::Warning, code::kZoneCut,
         ClausePlace(zoned == before.line ? before.zone_line : 0, zoned).place,
         fmt::format("ZONE cannot be used in full: {} are too short for it, and leave {} at"
                     " most, and what a bound on jerk adds to that",
                     meeting(zoned, line), shown(planned.zone_left, motion::AxisKind::Linear)),
         "a ZONE of that size says so in the program"});
  }
  if ((planned.warnings & motion::PlannedSegment::kZoneRaised) != 0) {
    const ClausePlace at(move.zone_line, line);
    log.found({lang::Severity::Warning, code::kZoneRaised, at.place,
               fmt::format("ZONE asks for a tighter corner than the axes can take; it becomes"
                           " ZONE {}s{}",
                           shown(planned.segment.t_acc, 3), at.first),
               "FINE reaches the target exactly"});
  }
  if ((planned.warnings & motion::PlannedSegment::kCornerExact) != 0) {
    log.found({lang::Severity::Warning, code::kCornerExact, place,
               fmt::format("{} have no corner within what the axes can do: the target between them"
                           " is reached exactly",
                           meeting(before.line, line)),
               "FINE at that target says so; a slower AT or a greater ZONE leaves room for it"});
  }
}

}  // namespace rob::runtime
