#include "lang/check/checker.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include "lang/check/control_flow.h"
#include "lang/check/expression_checker.h"
#include "lang/check/names.h"
#include "lang/check/routine_uses.h"
#include "lang/check/statement_checker.h"
#include "lang/check/symbols.h"
#include "lang/check/value_checker.h"
#include "lang/code/chunk.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

namespace rob::lang {
namespace {

/// Checks a whole program: the top level first, then the routines, which see all its names.
class ProgramChecker {
 public:
  ProgramChecker(CheckedProgram& checked, const RobotSignature& robot, const PointTable& points,
                 const TargetJudge& judge, Diagnostics& diagnostics)
      : checked_(checked),
        program_(checked.program),
        diagnostics_(diagnostics),
        scopes_(checked.symbols, robot),
        uses_(program_.routines.size()),
        declarations_(scopes_, uses_, program_.entry, diagnostics),
        names_(scopes_, program_, uses_, diagnostics),
        values_(scopes_, diagnostics),
        expressions_(scopes_, program_, names_, values_, robot, uses_, missing_, diagnostics),
        statements_(checked, scopes_, declarations_, names_, expressions_, values_, missing_, uses_,
                    robot, points, judge, diagnostics) {}

  void check(KnownNames known);

 private:
  void declare(KnownNames known);
  void check_frame_uses();
  void check_test_names();
  void settle_tasks();
  void settle_handlers();
  void warn_of_missing_points();

  CheckedProgram& checked_;
  Program& program_;
  Diagnostics& diagnostics_;
  Scopes scopes_;
  RoutineUses uses_;
  MissingPoints missing_;
  Declarations declarations_;
  Names names_;
  ValueChecker values_;
  ExpressionChecker expressions_;
  StatementChecker statements_;
};

void ProgramChecker::check(KnownNames known) {
  scopes_.enter();
  declare(known);
  for (const Routine& routine : program_.routines) {
    scopes_.enter_file(routine.place.file);
    if (!routine.test && !routine.handler) declarations_.declare(routine);
  }
  scopes_.enter_file(0);
  for (Statement& statement : program_.statements) {
    uses_.next_statement();
    statements_.check(statement);
  }
  program_.memory = statements_.take_memory_use();
  statements_.warn_of_zones(program_.statements);
  missing_.enter_routines();
  statements_.enter_routines();
  for (Routine& routine : program_.routines) {
    if (!routine.handler) statements_.check(routine);
  }
  check_frame_uses();
  check_test_names();
  settle_tasks();
  settle_handlers();
  warn_of_missing_points();
  scopes_.leave();
  uses_.report(diagnostics_);
  warn_of_corner_readings(program_, diagnostics_);
}

void ProgramChecker::declare(KnownNames known) {
  for (const KeptName* const kept : known) {
    statements_.know(*kept, declarations_.declare(*kept, checked_.known));
  }
}

void ProgramChecker::check_frame_uses() {
  for (const Program::FrameUse& use : program_.frame_uses) {
    if (scopes_.frame_of(use.frame) != nullptr) continue;
    scopes_.enter_file(use.place.file);
    const Symbol* const symbol = scopes_.find_global(use.frame->name);
    if (symbol != nullptr && !symbol->type.known()) continue;
    diagnostics_.error(code::kNoFrame, use.place,
                       fmt::format("{} is no FRAME of this program", shortened(use.frame->name)),
                       fmt::format("FRAME {} = POSE(…) declares one", shortened(use.frame->name)));
  }
}

/// A report of tests says which one has failed by its name.
void ProgramChecker::check_test_names() {
  std::map<std::pair<std::uint32_t, std::string_view>, const Routine*> named;
  for (const Routine& routine : program_.routines) {
    if (!routine.test || !routine.sound) continue;
    const auto [earlier, is_new] = named.try_emplace({routine.place.file, routine.name}, &routine);
    if (is_new) continue;
    diagnostics_.error(code::kDeclaredTwice, routine.name_place,
                       fmt::format("there is a TEST of this name already, in line {}",
                                   earlier->second->place.line),
                       "give one of them another name");
  }
}

/// When all is checked it is known what TASKs use and change, what a WAIT may wait for,
/// and what a PATH reads.
void ProgramChecker::settle_tasks() {
  std::set<std::pair<std::uint32_t, std::string>> tasks;  // at the prompt one may be declared anew
  for (const Routine& routine : program_.routines) {
    if (routine.task) tasks.emplace(routine.place.file, to_upper(routine.name));
  }
  if (tasks.size() > kMostTasks) {
    diagnostics_.error(
        code::kTooManyTasks, program_.end,
        fmt::format("the program has {} TASKs; at most {} can be", tasks.size(), kMostTasks),
        "one TASK can look after several things");
  }
  uses_.report_tasks(program_.routines, diagnostics_);
  for (Routine& routine : program_.routines) {
    const bool earlier = routine.task && routine.place.line < program_.entry;
    routine.outdated = earlier && uses_.uses_since(routine, program_.entry, program_.routines);
  }
  if (program_.entry != 0) uses_.share_with_handlers(program_.routines);
  for (const RoutineUses::Shared& one : uses_.shared())
    scopes_.share(*one.symbol, one.observed, one.of_tasks);
  statements_.report_waits_and_paths();
  uses_.report_paths(program_.routines, diagnostics_);
}

void ProgramChecker::settle_handlers() {
  uses_.report_handlers(program_.routines, diagnostics_);
  for (Routine& routine : program_.routines) {
    if (!routine.handler) continue;
    routine.stops = uses_.stops(routine);
    routine.captured = uses_.captured(routine);
  }
}

void ProgramChecker::warn_of_missing_points() {
  for (MissingPoint& point : missing_.found()) {
    diagnostics_.warning(
        code::kPointMissing, point.place,
        fmt::format("nobody has taught {}: the points file of the program does not have it",
                    shortened(point.name)),
        fmt::format("TEACH {0} before its first use, or give it a value: POINT {0} = POSE(…)",
                    shortened(point.name)));
    checked_.missing_points.push_back(std::move(point));
  }
}

}  // namespace

CheckedProgram check(Program program, const RobotSignature& robot, const PointTable& points,
                     const TargetJudge& judge, Diagnostics& diagnostics, KnownNames known) {
  CheckedProgram checked{
      .program = std::move(program), .symbols = {}, .features = {}, .missing_points = {}};
  TypeDetail& joints = *checked.program.types->joints;
  if (joints.axes.empty()) {  // else it is that of an earlier entry of the prompt
    for (const RobotSignature::Coordinate& axis : robot.axes) joints.axes.push_back(axis.dimension);
    joints.slots.numbers = static_cast<int>(joints.axes.size());
  }
  ProgramChecker(checked, robot, points, judge, diagnostics).check(known);
  return checked;
}

}  // namespace rob::lang
