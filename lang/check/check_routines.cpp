#include <string>

#include <fmt/core.h>

#include "lang/check/corner_readings.h"
#include "lang/check/fold.h"
#include "lang/check/return_paths.h"
#include "lang/check/statement_checker.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// Member functions of StatementChecker for PROC, FUNC and RETURN.
namespace rob::lang {

void StatementChecker::check(Program& program, KnownNames known) {
  scopes_.enter();
  declare(known);
  for (const Routine& routine : program.routines) {
    scopes_.enter_file(routine.place.file);
    if (!routine.test && !routine.handler) declare(routine);
  }
  scopes_.enter_file(0);
  for (Statement& statement : program.statements) {
    uses_.next_statement();
    check(statement);
  }
  program.memory = take_memory_use();
  moves_.warn_of_zones(program.statements);
  missing_.enter_routines();
  moves_.in_routine(true);
  for (Routine& routine : program.routines) {
    if (!routine.handler) check(routine);
  }
  check_frame_uses(program);
  check_test_names(program);
  settle_tasks(program);
  settle_handlers();
  warn_of_missing_points();
  scopes_.leave();
  uses_.report(diagnostics_);
  warn_of_corner_readings(program, diagnostics_);
}

void StatementChecker::declare(KnownNames known) {
  for (const KeptName* const kept : known) {
    const Symbol& symbol = kept_names_.declare(*kept);
    if (kept->safe) safe_lines_.try_emplace(symbol.signal, symbol.place);
    if (symbol.kind == Symbol::Kind::Point)
      points_declared_.try_emplace(to_upper(symbol.name), symbol.place);
  }
}

void StatementChecker::declare(const Routine& routine) {
  const Symbol* const earlier = scopes_.find_innermost(routine.name);
  if (earlier != nullptr && !may_be_anew(Symbol::Kind::Routine, *earlier)) {
    diagnostics_.error(code::kDeclaredTwice, routine.name_place,
                       fmt::format("{} is already declared, in line {}", shortened(routine.name),
                                   earlier->place.line),
                       "give one of them another name");
    return;
  }
  const Symbol* const symbol =
      declare(Symbol::Kind::Routine, routine.name, routine.name_place, routine.result, {});
  scopes_.define(*symbol, routine);
}

void StatementChecker::check(Routine& routine) {
  scopes_.enter_file(routine.place.file);
  inside_.routine = &routine;
  uses_.enter(&routine);
  expressions_.complete_header(routine);
  scopes_.enter();
  check_parameters(routine);
  for (Statement& statement : routine.body) check(statement);
  scopes_.leave();
  routine.memory = take_memory_use();
  uses_.enter(nullptr);
  inside_.routine = nullptr;
  if (routine.function) check_returns(routine);
}

/// Where a line could not be read it may have been the RETURN.
void StatementChecker::check_returns(const Routine& routine) {
  if (!routine.whole) return;
  const auto way = way_without_return(routine.body);
  if (!way) return;
  diagnostics_.error(code::kReturnMissing, routine.end,
                     fmt::format("{} can end without RETURN: {}", shortened(routine.name), *way),
                     "RETURN a value there, or RAISE an error if this cannot happen");
}

void StatementChecker::check_parameters(Routine& routine) {
  for (Routine::Parameters& group : routine.parameters) {
    if (group.value != nullptr) {
      expressions_.check(group.value);
      expressions_.accept(*group.value, group.type,
                          fmt::format("{} needs", shortened(group.names.front().name)));
      const bool unknown = group.value->type.kind == Type::Kind::Unknown;
      if (group.by_reference) {
        diagnostics_.error(code::kReferenceArgument, group.value->place,
                           "a REF parameter has no default", "it stands for a variable");
      } else if (!unknown && !known(group.value->constant)) {
        diagnostics_.error(code::kDefaultNotConstant, group.value->place,
                           "a default has to be constant",
                           "give the value where the routine is called");
      }
    }
    for (Declaration::Declared& declared : group.names) {
      const Symbol* const symbol =
          declare(Symbol::Kind::Variable, declared.name, declared.place, group.type, {});
      if (group.by_reference) scopes_.refer(*symbol);
      declared.symbol = symbol;
    }
  }
}

void StatementChecker::check(Return& statement) {
  if (inside_.routine != nullptr && inside_.routine->handler) {
    diagnostics_.error(code::kMisplaced, place_, "RETURN cannot leave the handler of a WHEN",
                       "the program goes on where it was interrupted");
    return;
  }
  expressions_.check(statement.value);
  const bool wanted = inside_.routine != nullptr && inside_.routine->function;
  if (wanted && statement.value != nullptr) {
    expressions_.accept(*statement.value, inside_.routine->result,
                        fmt::format("{} returns", shortened(inside_.routine->name)));
  } else if (wanted) {
    diagnostics_.error(
        code::kReturnValue, place_,
        fmt::format("RETURN needs the value of {}", shortened(inside_.routine->name)),
        "for example RETURN " + example_of(inside_.routine->result.dimension));
  } else if (statement.value != nullptr) {
    diagnostics_.error(code::kReturnValue, statement.value->place,
                       inside_.routine == nullptr ? "the program has no value to return"
                                                  : "a PROC has no value to return",
                       "write RETURN alone, or make it a FUNC");
  }
}

}  // namespace rob::lang
