#include <fmt/core.h>

#include "lang/check/statement_checker.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// Member functions of StatementChecker for HALT and ASK, and for the operator whom SIMULATE plays.
namespace rob::lang {

void StatementChecker::check(Halt& halt) {
  expressions_.check(halt.text);
  if (halt.text != nullptr) expressions_.accept(*halt.text, Type::string(), "HALT needs");
}

void StatementChecker::check(Ask& ask) {
  expressions_.check(ask.text);
  if (ask.text != nullptr) expressions_.accept(*ask.text, Type::string(), "ASK needs");
  const Type type = expressions_.check(ask.target);
  if (ask.target == nullptr) return;
  const Name* const root = root_of(*ask.target);
  if (root != nullptr && root->symbol == nullptr) return;
  const auto refuse = [&](std::string message) {
    diagnostics_.error(code::kNotAskable, ask.target->place, std::move(message),
                       "VAR count = 0, then ASK \"how many? \" INTO count");
  };
  if (root == nullptr || root->symbol->kind == Symbol::Kind::Signal) {
    return refuse("ASK fills a variable, or a part of one");
  }
  if (!assignable(*root->symbol, ask.target->place) || !type.known()) return;
  const auto* const member = std::get_if<Member>(&ask.target->node);
  const bool angle = member != nullptr && angle_of(member->object->type, member->field);
  if (!type.scalar() || angle) {
    refuse(fmt::format("ASK reads a number, a text, or TRUE or FALSE; this is {}",
                       angle ? "an angle of a pose" : in_words(type)));
  }
}

void StatementChecker::check_operators_simulation(const Simulate& simulation) {
  if (simulation.value == nullptr) return;
  const bool go = simulation.what == Simulate::What::Go;
  expressions_.accept(*simulation.value, go ? Type::boolean() : Type::string(),
                      go ? "GO needs" : "ANSWER needs");
}

}  // namespace rob::lang
