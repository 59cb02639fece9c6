#include "lang/routine.h"
#include "lang/statement_compiler.h"

/// The part of StatementCompiler that knows PROC, FUNC and RETURN.
namespace rob::lang {

/// The parameters are the first registers, as the caller has laid them out.
void StatementCompiler::compile(const Routine& routine) {
  routine_ = &routine;
  code_.begin_routine(routine.name);
  const auto mark = code_.mark();
  for (const Parameter& parameter : parameters_of(routine)) {
    const Register home = parameter.is_text() ? code_.text_register() : code_.number_registers();
    code_.name_register(parameter.declared->name, home, parameter.is_text());
    expressions_.settle(*parameter.declared->symbol, home);
  }
  compile(routine.body);
  code_.emit(routine.function ? Opcode::no_value : Opcode::leave, routine.end);
  code_.release(mark);
  routine_ = nullptr;
}

void StatementCompiler::compile(const Return& statement) {
  const Place place = place_;
  if (routine_ == nullptr) {
    leave_guards(0, place);
    returns_.push_back(code_.jump(place));
  } else if (statement.value == nullptr) {
    leave_guards(0, place);
    code_.emit(Opcode::leave, place);
  } else {
    const auto mark = code_.mark();
    const bool text = routine_->result.kind == Type::Kind::String;
    const Register value =
        expressions_.value(*statement.value, routine_->result.kind == Type::Kind::Real);
    leave_guards(0, place);
    code_.emit(text ? Opcode::leave_with_text : Opcode::leave_with, place, value);
    code_.release(mark);
  }
}

}  // namespace rob::lang
