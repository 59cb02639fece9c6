#include <algorithm>

#include <fmt/core.h>

#include "lang/check/statement_checker.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// Member functions of StatementChecker for TASK and START.
namespace rob::lang {
namespace {

// [choice] TASKs look after things beside the program; one of many small programs is another
// language.
constexpr std::size_t kMostTasks = 16;

}  // namespace

void StatementChecker::check(Start& start) {
  const Symbol* symbol = scopes_.find(start.task.text);
  if (symbol == nullptr || symbol->kind != Symbol::Kind::Routine) {
    symbol = expressions_.resolve(start.task.text, start.task_place);
  }
  start.task.symbol = symbol;
  if (symbol == nullptr) return;
  if (symbol->routine == nullptr || !symbol->routine->task) {
    diagnostics_.error(code::kNotATask, start.task_place,
                       fmt::format("{} is no TASK", shortened(symbol->name)),
                       "START blink needs TASK blink … ENDTASK");
    return;
  }
  uses_.called(*symbol->routine, start.task_place);
}

/// When all is checked it is known what TASKs use and change, what a WAIT may wait for,
/// and what a PATH reads.
void StatementChecker::settle_tasks(const Program& program) {
  const auto tasks = std::ranges::count_if(program.routines, &Routine::task);
  if (static_cast<std::size_t>(tasks) > kMostTasks) {
    diagnostics_.error(
        code::kTooManyTasks, program.end,
        fmt::format("the program has {} TASKs; at most {} can be", tasks, kMostTasks),
        "one TASK can look after several things");
  }
  uses_.report_tasks(program.routines, diagnostics_);
  for (const RoutineUses::Shared& one : uses_.shared()) scopes_.share(*one.symbol, one.observed);
  waits_.report_hopeless(uses_);
  report_reads_in_paths();
  uses_.report_paths(program.routines, diagnostics_);
}

}  // namespace rob::lang
