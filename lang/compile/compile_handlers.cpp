#include "lang/compile/statement_compiler.h"

/// Member functions of StatementCompiler that give a handler the variables around it.
namespace rob::lang {

/// The places of the variables that a handler uses of those around it, number slots before text
/// slots, in registers that stay its own until the block of the WHEN ends.
Register StatementCompiler::capture(const Routine& handler) {
  const Register first = code_.number_registers(captures_of(handler));
  Register next = first;
  for (const Symbol* const symbol : handler.captured) {
    const Slots slots = slots_of(symbol->type);
    if (slots.numbers > 0) expressions_.refer(*symbol, false, next++, place_);
    if (slots.texts > 0) expressions_.refer(*symbol, true, next++, place_);
  }
  return first;
}

int StatementCompiler::captures_of(const Routine& handler) {
  int count = 0;
  for (const Symbol* const symbol : handler.captured) {
    const Slots slots = slots_of(symbol->type);
    count += (slots.numbers > 0 ? 1 : 0) + (slots.texts > 0 ? 1 : 0);
  }
  return count;
}

/// They are a handler's first registers, as REF parameters are a routine's.
void StatementCompiler::settle_captured(const Routine& handler) {
  Register next = code_.number_registers(captures_of(handler));
  for (const Symbol* const symbol : handler.captured) {
    const Slots slots = slots_of(symbol->type);
    Location home{{SlotsAt::Base::Place}, {SlotsAt::Base::Place}};
    if (slots.numbers > 0) home.numbers.place = next++;
    if (slots.texts > 0) home.texts.place = next++;
    expressions_.settle(*symbol, home);
  }
}

}  // namespace rob::lang
