#include <algorithm>
#include <iterator>
#include <vector>

#include "lang/check/observations.h"
#include "lang/compile/statement_compiler.h"

/// Code for TASK and START, and for the globals that TASKs use: the program has its own copy of
/// them. What it gives them is published behind each assignment; what TASKs give them is fetched
/// before each expression.
namespace rob::lang {

void StatementCompiler::compile(const Start& start) {
  const Routine& routine = *start.task.symbol->routine;
  code_.start(task_numbers_.at(routine.index), place_);
}

void StatementCompiler::publish(const Symbol& symbol, Place place) {
  expressions_.publish(symbol, place);
}

void ExpressionCompiler::publish(const Symbol& symbol, Place place) {
  if (symbol.shared) publish(home(symbol), symbol.type, place);
}

void ExpressionCompiler::publish(const Location& at, const Type& type, Place place) {
  const Slots slots = slots_of(type);
  const auto mark = code_.mark();
  const Register first = code_.number_registers();
  if (slots.numbers > 0) {
    refer(at.numbers, false, first, place);
    code_.publish(first, false, slots.numbers, place);
  }
  if (slots.texts > 0) {
    refer(at.texts, true, first, place);
    code_.publish(first, true, slots.texts, place);
  }
  code_.release(mark);
}

/// Of a place that is assigned only what its indices read is observed.
void ExpressionCompiler::begin_place(const Expr& target) {
  int count = 0;
  std::vector<const Symbol*> globals;
  for (const Expr* at = &target;;) {
    if (const auto* const member = std::get_if<Member>(&at->node)) {
      at = member->object.get();
    } else if (const auto* const index = std::get_if<Index>(&at->node)) {
      count += observations(*index->index);
      std::ranges::copy(observed_globals(*index->index), std::back_inserter(globals));
      at = index->object.get();
    } else {
      break;
    }
  }
  latched_ = count > 1;
  if (latched_) code_.emit(Opcode::latch, target.place);
  refresh(globals, target.place);
}

/// Globals lie where they are known to lie: at the beginning of the registers, or of the memory.
void ExpressionCompiler::refresh(const std::vector<const Symbol*>& globals, Place place) {
  for (const Symbol* const global : globals) {
    const Slots slots = slots_of(global->type);
    const Location& at = homes_[global->id];
    const bool in_memory = at.numbers.base == SlotsAt::Base::Place;
    code_.refresh((in_memory ? kNumberStack : 0) + at.numbers.offset, false, slots.numbers,
                  latched_, place);
    code_.refresh((in_memory ? kTextStack : 0) + at.texts.offset, true, slots.texts, latched_,
                  place);
  }
}

}  // namespace rob::lang
