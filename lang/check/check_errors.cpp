#include "lang/check/statement_checker.h"
#include "lang/text/codes.h"

/// Member functions of StatementChecker for TRY and RAISE.
namespace rob::lang {

void StatementChecker::check(Try& statement) {
  check(statement.body);
  const Slots declared = inside_.declared;
  scopes_.enter();
  Declaration::Declared& why = statement.why;
  if (!why.name.empty()) {
    why.symbol = declare(Symbol::Kind::Variable, why.name, why.place, Type::string(), {});
  }
  ++inside_.rescues;
  check(statement.rescue);
  --inside_.rescues;
  scopes_.leave();
  inside_.declared = declared;
}

void StatementChecker::check(Raise& statement) {
  if (statement.value != nullptr) {
    expressions_.check(statement.value);
    expressions_.accept(*statement.value, Type::string(), "RAISE needs");
  } else if (inside_.rescues == 0) {
    diagnostics_.error(code::kNothingToRaise, place_,
                       "RAISE without a text raises the error of its RESCUE again; there is none",
                       "say what is wrong, for example RAISE \"no part\"");
  }
}

}  // namespace rob::lang
