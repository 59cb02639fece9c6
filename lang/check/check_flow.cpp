#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/check/statement_checker.h"
#include "lang/text/codes.h"

/// Member functions of StatementChecker for LOOP, EXIT, NEXT and SELECT.
namespace rob::lang {

void StatementChecker::check_body(Block& body) {
  ++inside_.loops;
  check(body);
  --inside_.loops;
}

void StatementChecker::check(Loop& loop) { check_body(loop.body); }

void StatementChecker::require_loop(std::string_view word) {
  if (inside_.loops > 0) return;
  diagnostics_.error(code::kMisplaced, place_,
                     fmt::format("{} can only stand inside LOOP, WHILE or FOR", word));
}

void StatementChecker::check(Select& select) {
  const Type type = expressions_.check(select.selector);
  if (!type.scalar()) {
    diagnostics_.error(code::kTypeMismatch, select.selector->place,
                       fmt::format("SELECT compares single values; this is {}", in_words(type)),
                       "select by one of its parts");
    select.selector->type = Type{};
  }
  CaseLines lines;
  for (Select::Case& one : select.cases) {
    for (const ExprPtr& value : one.values) {
      expressions_.check(value);
      if (select.selector && value) check_case(select.selector->type, *value, lines);
    }
    check(one.body);
  }
  check(select.otherwise);
}

/// The value must be of the selector's kind, and may not stand in a CASE above it.
void StatementChecker::check_case(const Type& wanted, const Expr& value, CaseLines& lines) {
  const Type& type = value.type;
  if (wanted.kind == Type::Kind::Unknown || type.kind == Type::Kind::Unknown) return;
  if (common_type(wanted, type).kind == Type::Kind::Unknown) {
    expressions_.accept(value, wanted, "the SELECT compares with");
    return;
  }
  if (!known(value.constant)) return;
  const auto [earlier, added] =
      lines.try_emplace(converted(value.constant, wanted), value.place.line);
  if (added) return;
  diagnostics_.error(
      code::kCaseTwice, value.place,
      fmt::format("this value stands in line {} already: its CASE is taken", earlier->second),
      "leave it out here");
}

}  // namespace rob::lang
