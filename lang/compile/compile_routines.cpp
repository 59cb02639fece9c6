#include <algorithm>

#include "lang/check/routine.h"
#include "lang/compile/statement_compiler.h"

/// Member functions of StatementCompiler for PROC, FUNC and RETURN.
namespace rob::lang {

CallLayout layout_of(const Routine& routine) {
  CallLayout layout;
  const auto places = [&layout](Slots slots) {
    Location home{{SlotsAt::Base::Place}, {SlotsAt::Base::Place}};
    if (slots.numbers > 0) home.numbers.place = static_cast<Register>(layout.registers++);
    if (slots.texts > 0) home.texts.place = static_cast<Register>(layout.registers++);
    return home;
  };
  for (const Parameter& parameter : parameters_of(routine)) {
    const Slots slots = slots_of(parameter.group->type);
    Location home;
    if (parameter.group->by_reference || !parameter.group->type.in_registers()) {
      home = places(slots);
    } else {
      home.numbers.offset = static_cast<std::uint32_t>(layout.registers);
      home.texts.offset = static_cast<std::uint32_t>(layout.text_registers);
      layout.registers += slots.numbers;
      layout.text_registers += slots.texts;
    }
    layout.homes.push_back(home);
  }
  const Slots result = slots_of(routine.result);
  if (!routine.result.in_registers()) {
    layout.result = places(result);
    return layout;
  }
  layout.registers = std::max(layout.registers, result.numbers);
  layout.text_registers = std::max(layout.text_registers, result.texts);
  return layout;
}

/// The parameters are the first registers, as the caller has laid them out.
void StatementCompiler::compile(const Routine& routine) {
  routine_ = &routine;
  if (routine.test) {
    code_.add_test({routine.name, routine.place, static_cast<std::uint32_t>(routine.index)});
  }
  if (routine.task) code_.add_task({routine.name, static_cast<std::uint32_t>(routine.index)});
  whens_ = 0;
  code_.begin_routine(routine.name, routine.place, routine.handler);
  const auto mark = code_.mark();
  const CallLayout layout = layout_of(routine);
  const auto parameters = parameters_of(routine);
  code_.number_registers(layout.registers);
  code_.text_registers(layout.text_registers);
  if (routine.handler) settle_captured(routine);
  if (routine.memory) code_.open_memory(routine.place);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Symbol& symbol = *parameters[i].declared->symbol;
    Location home = layout.homes[i];
    const bool by_reference = parameters[i].group->by_reference;
    if (!by_reference && !symbol.type.in_registers()) {
      const Slots slots = slots_of(symbol.type);
      home = expressions_.memory(slots, routine.place);
      expressions_.copy_memory(home, layout.homes[i], slots, routine.place);
    } else if (!by_reference) {
      name_home(symbol, home);
    }
    expressions_.settle(symbol, home);
  }
  compile(routine.body);
  // A FUNC never comes here: the checker has seen that it RETURNs before.
  code_.emit(routine.handler ? Opcode::leave_handler : Opcode::leave, routine.end);
  code_.release(mark);
  routine_ = nullptr;
}

void StatementCompiler::compile(const Return& statement) {
  const Place place = place_;
  if (routine_ == nullptr) {
    leave_guards(0, place);
    leave_scopes(0, place);
    returns_.push_back(code_.jump(place));
  } else if (statement.value == nullptr) {
    leave_whens(0);
    leave_guards(0, place);
    leave_scopes(0, place);
    code_.emit(Opcode::leave, place);
  } else if (!routine_->result.in_registers()) {
    expressions_.initialise(*statement.value, layout_of(*routine_).result, routine_->result);
    leave_whens(0);
    leave_guards(0, place);
    leave_scopes(0, place);
    code_.emit(Opcode::leave, place);
  } else {
    const auto mark = code_.mark();
    const Type& type = routine_->result;
    const Register value = expressions_.value(*statement.value, type.is(Type::Kind::Real));
    leave_whens(0);
    leave_guards(0, place);
    leave_scopes(0, place);
    if (type.is(Type::Kind::String)) {
      code_.emit(Opcode::leave_with_text, place, value);
    } else {
      code_.emit(Opcode::leave_with, place, value, static_cast<unsigned>(slots_of(type).numbers));
    }
    code_.release(mark);
  }
}

}  // namespace rob::lang
