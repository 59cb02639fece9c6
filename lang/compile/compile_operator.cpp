#include "lang/compile/statement_compiler.h"

/// Member functions of StatementCompiler for HALT and ASK, and for the operator whom SIMULATE
/// plays.
namespace rob::lang {

void StatementCompiler::compile(const Halt& halt) {
  const Place place = place_;
  const auto mark = code_.mark();
  if (halt.text != nullptr) {
    code_.emit(Opcode::halt, place, expressions_.value(*halt.text));
  } else {
    const Register text = code_.text_register();
    code_.load_text(text, "", place);
    code_.emit(Opcode::halt, place, text);
  }
  code_.release(mark);
}

/// The variable is read before: where nobody answers, while the program is foretold, it keeps its
/// value.
void StatementCompiler::compile(const Ask& ask) {
  const Place place = place_;
  const Type& type = ask.target->type;
  const auto mark = code_.mark();
  const bool text = type.is(Type::Kind::String);
  const Register answer = text ? code_.text_register() : code_.number_registers();
  expressions_.value_into(*ask.target, answer);
  code_.ask(expressions_.value(*ask.text), answer, type, place);
  expressions_.assign_register(*ask.target, answer);
  code_.release(mark);
}

void StatementCompiler::simulate_operator(const Simulate& simulation, Register value) {
  if (simulation.what == Simulate::What::Go) {
    expressions_.value_into(*simulation.value, value);
    code_.emit(Opcode::simulate_go, place_, value);
  } else {
    code_.emit(Opcode::simulate_answer, place_, value, expressions_.value(*simulation.value));
  }
}

}  // namespace rob::lang
