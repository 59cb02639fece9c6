#include <algorithm>
#include <vector>

#include "lang/expression_compiler.h"
#include "lang/fold.h"
#include "lang/observations.h"
#include "lang/statement_compiler.h"

/// Code for what is evaluated in every control cycle, and for the statements that it belongs to.
namespace rob::lang {
namespace {

bool is_variable(const Symbol& symbol) {
  return symbol.kind != Symbol::Kind::Signal && !known(symbol.value);
}

/// The variables of an expression, each once: what is to be fixed when the statement is executed.
void gather(const Expr& expression, std::vector<const Symbol*>& variables) {
  if (known(expression.constant)) return;
  if (const auto* const name = std::get_if<Name>(&expression.node)) {
    const bool is_new = std::ranges::find(variables, name->symbol) == variables.end();
    if (is_variable(*name->symbol) && is_new) variables.push_back(name->symbol);
  } else if (const auto* const unary = std::get_if<Unary>(&expression.node)) {
    gather(*unary->operand, variables);
  } else if (const auto* const binary = std::get_if<Binary>(&expression.node)) {
    gather(*binary->left, variables);
    gather(*binary->right, variables);
  } else if (const auto* const call = std::get_if<Call>(&expression.node)) {
    for (const ExprPtr& argument : call->arguments) gather(*argument, variables);
  }
}

}  // namespace

ExpressionCompiler::WatchCode ExpressionCompiler::watch(const Expr& condition) {
  std::vector<const Symbol*> variables;
  gather(condition, variables);
  const Place place = condition.place;
  const int count = static_cast<int>(variables.size());
  latched_ = false;
  refresh(observed_globals(condition), place);
  const Register values = code_.number_registers(std::max(count, 1));
  for (int i = 0; i < count; ++i) {
    const Symbol& variable = *variables[static_cast<std::size_t>(i)];
    const auto value = static_cast<Register>(values + i);
    if (lives_in_register(variable)) {
      load(home(variable), variable.type, value, place);
    } else {
      code_.emit(Opcode::read_hit, place, value);
    }
  }
  code_.begin_watch(place);
  std::vector<Location> homes;
  for (const Symbol* const variable : variables) {
    homes.push_back(homes_[variable->id]);
    settle(*variable, Location{{SlotsAt::Base::Own, code_.number_registers()}, {}});
  }
  latched_ = false;
  watching_ = true;
  const Register answer = operand(condition, false);
  watching_ = false;
  for (std::size_t i = 0; i < variables.size(); ++i) settle(*variables[i], homes[i]);
  return {code_.end_watch(answer, count, place), values};
}

void StatementCompiler::compile(const When& when) {
  const Place place = place_;
  const auto mark = code_.mark();
  const ExpressionCompiler::WatchCode watch = expressions_.watch(*when.condition);
  code_.when(watch.values, watch.index, whens_++, place);
  if (const auto* const raise = std::get_if<Raise>(&when.action.front().node)) {
    code_.emit(Opcode::when_raise, place, expressions_.value(*raise->value));
  } else {
    compile(when.action);
  }
  code_.release(mark);
}

void StatementCompiler::leave_whens(std::size_t kept) {
  if (whens_ == kept) return;
  code_.emit(Instruction::ax(Opcode::disarm, 0, static_cast<std::uint16_t>(kept)), place_);
}

void StatementCompiler::compile(const WayPoint& event) {
  const auto mark = code_.mark();
  const Register distance = code_.number_registers(2);
  const auto lead = static_cast<Register>(distance + 1);
  expressions_.value_into(*event.distance, distance);
  if (event.shift == nullptr) {
    code_.load_real(lead, 0, kTime, event.place);
  } else {
    expressions_.value_into(*event.shift, lead);
    if (event.lag) code_.emit(Opcode::neg_real, event.place, lead, lead);
  }
  code_.emit(Opcode::on_the_way, event.place, distance, event.before ? 1 : 0);
  compile(event.action);
  code_.release(mark);
}

/// The guard is set before the motion is commanded, and asked for behind it.
void StatementCompiler::compile(const WatchedMotion& watched) {
  const Place place = place_;
  const auto mark = code_.mark();
  for (const WayPoint& event : watched.events) compile(event);
  if (watched.until == nullptr) return compile(watched.motion);
  const ExpressionCompiler::WatchCode watch = expressions_.watch(*watched.until);
  code_.emit(Instruction::ax(Opcode::guard, watch.values, watch.index), place);
  compile(watched.motion);
  const Register hit = code_.number_registers();
  code_.emit(Opcode::ended, place, hit);
  if (watched.has_else) {
    code_.emit(Opcode::if_bool, place, hit, 1);
    const CodeBuilder::Jump done = code_.jump(place);
    compile(watched.otherwise);
    code_.land(done);
  }
  code_.release(mark);
}

}  // namespace rob::lang
