#include <fmt/core.h>

#include "lang/compile/statement_compiler.h"
#include "lang/values/number_text.h"

/// Member functions of StatementCompiler for TEST, EXPECT and SIMULATE.
namespace rob::lang {

/// A TEST begins like the program, with its declarations and without its statements; they take the
/// same registers again, since all else gives back what it has taken.
void StatementCompiler::compile_test_entry(const Program& program) {
  code_.begin_tests();
  const auto mark = code_.mark();
  if (program.memory) code_.open_memory(program.end);
  compile_variables(program.statements);
  code_.call_test(program.end);
  code_.emit(Opcode::end, program.end);
  code_.release(mark);
}

/// What a SIGNAL declares stands in the Chunk already.
void StatementCompiler::compile_variables(const Block& statements) {
  for (const Statement& statement : statements) {
    if (const Use* const use = std::get_if<Use>(&statement.node)) {
      compile_variables(use->declarations);
    } else if (std::holds_alternative<Declaration>(statement.node) ||
               std::holds_alternative<PointDeclaration>(statement.node)) {
      compile(statement);
    }
  }
}

void StatementCompiler::compile(const Expect& expectation) {
  const Place place = place_;
  const auto mark = code_.mark();
  const Register text = code_.text_register();
  const Expr& condition = *expectation.condition;
  const auto compared = expressions_.compare(condition);
  const CodeBuilder::Jumps holds =
      compared ? compared->holds : expressions_.jumps_if(condition, true);
  code_.load_text(text, expectation.text + (compared ? " does not hold: left " : " does not hold"),
                  place);
  if (compared) {
    const Binary& binary = std::get<Binary>(condition.node);
    expressions_.append_register(compared->left, binary.left->type, compared->real, text, place);
    const Register between = code_.text_register();
    code_.load_text(between, ", right ", place);
    code_.emit(Opcode::append_text, place, text, between);
    expressions_.append_register(compared->right, binary.right->type, compared->real, text, place);
  }
  code_.emit(Opcode::expect_failed, place, text);
  code_.land(holds);
  code_.release(mark);
}

void StatementCompiler::compile(const Simulate& simulation) {
  const auto mark = code_.mark();
  const Register value = code_.number_registers(2);
  const auto after = static_cast<Register>(value + 1);
  if (simulation.after != nullptr) {
    expressions_.value_into(*simulation.after, after);
  } else {
    code_.load_real(after, 0, kTime, place_);
  }
  if (simulation.what != Simulate::What::Input) {
    simulate_operator(simulation, value);
    return code_.release(mark);
  }
  const Symbol& symbol = *simulation.target.symbol;
  const bool force = symbol.kind == Symbol::Kind::Reading;
  expressions_.value_into(*simulation.value, value, symbol.analog || force);
  if (force) {
    expressions_.simulate_force(simulation.component, value, place_);
  } else {
    expressions_.simulate(symbol, value, place_);
  }
  code_.release(mark);
}

}  // namespace rob::lang
