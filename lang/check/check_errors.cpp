#include "lang/check/statement_checker.h"
#include "lang/text/codes.h"

/// The part of StatementChecker that knows TRY and RAISE.
namespace rob::lang {

void StatementChecker::check(Try& statement) {
  check(statement.body);
  const Slots declared = declared_;
  scopes_.enter();
  Declaration::Declared& why = statement.why;
  if (!why.name.empty()) {
    why.symbol = declare(Symbol::Kind::Variable, why.name, why.place, Type::string(), {});
  }
  ++rescues_;
  check(statement.rescue);
  --rescues_;
  scopes_.leave();
  declared_ = declared;
}

void StatementChecker::check(Raise& statement) {
  if (statement.value != nullptr) {
    expressions_.check(statement.value);
    expressions_.accept(*statement.value, Type::string(), "RAISE needs");
  } else if (rescues_ == 0) {
    diagnostics_.error(code::kNothingToRaise, place_,
                       "RAISE without a text raises the error of its RESCUE again; there is none",
                       "say what is wrong, for example RAISE \"no part\"");
  }
}

}  // namespace rob::lang
