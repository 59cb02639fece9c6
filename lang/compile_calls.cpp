#include <algorithm>

#include "lang/expression_compiler.h"
#include "lang/routine.h"

/// The part of ExpressionCompiler that knows routines, and where variables live that are not in
/// the present frame.
namespace rob::lang {
namespace {

bool is_text(const Type& type) { return type.kind == Type::Kind::String; }

}  // namespace

bool calls_routine(const Expr& expression) {
  struct Visitor {
    bool operator()(const Unary& unary) const { return calls_routine(*unary.operand); }
    bool operator()(const Binary& binary) const {
      return calls_routine(*binary.left) || calls_routine(*binary.right);
    }
    bool operator()(const Call& call) const {
      return call.routine != nullptr ||
             std::ranges::any_of(call.arguments,
                                 [](const ExprPtr& argument) { return calls_routine(*argument); });
    }
    bool operator()(const NumberLiteral&) const { return false; }
    bool operator()(const BoolLiteral&) const { return false; }
    bool operator()(const StringLiteral&) const { return false; }
    bool operator()(const Name&) const { return false; }
    bool operator()(const Tuple&) const { return false; }
  };
  return std::visit(Visitor{}, expression.node);
}

ExpressionCompiler::Reach ExpressionCompiler::reach(const Symbol& symbol) const {
  if (watching_) return Reach::Own;
  if (symbol.by_reference) return Reach::Reference;
  return in_routine_ && symbol.global ? Reach::Global : Reach::Own;
}

void ExpressionCompiler::load_variable(const Symbol& symbol, Register target, Place place) {
  const bool text = is_text(symbol.type);
  const Register from = home(symbol);
  switch (reach(symbol)) {
    case Reach::Own:
      return code_.emit(text ? Opcode::copy_text : Opcode::copy, place, target, from);
    case Reach::Global:
      return code_.emit(
          Instruction::ax(text ? Opcode::load_global_text : Opcode::load_global, target, from),
          place);
    case Reach::Reference:
      return code_.emit(text ? Opcode::load_reference_text : Opcode::load_reference, place, target,
                        from);
  }
}

void ExpressionCompiler::store_variable(const Symbol& symbol, Register value, Place place) {
  const bool text = is_text(symbol.type);
  const Register to = home(symbol);
  switch (reach(symbol)) {
    case Reach::Own:
      return code_.emit(text ? Opcode::copy_text : Opcode::copy, place, to, value);
    case Reach::Global:
      return code_.emit(
          Instruction::ax(text ? Opcode::store_global_text : Opcode::store_global, value, to),
          place);
    case Reach::Reference:
      return code_.emit(text ? Opcode::store_reference_text : Opcode::store_reference, place, value,
                        to);
  }
}

/// The place of a variable, for a REF parameter. The frame of the top level is the first on the
/// stack, so there a register's number is its place.
void ExpressionCompiler::refer(const Symbol& symbol, Register target, Place place) {
  switch (reach(symbol)) {
    case Reach::Own:
      return code_.emit(is_text(symbol.type) ? Opcode::refer_text : Opcode::refer, place, target,
                        home(symbol));
    case Reach::Global:
      return code_.load_integer(target, home(symbol), place);
    case Reach::Reference:
      return code_.emit(Opcode::copy, place, target, home(symbol));
  }
}

void ExpressionCompiler::assign(const Symbol& symbol, const Expr& value) {
  const bool as_real = symbol.type.kind == Type::Kind::Real;
  if (reach(symbol) == Reach::Own) return value_into(value, home(symbol), as_real);
  const auto mark = code_.mark();
  const Register result = is_text(symbol.type) ? code_.text_register() : code_.number_registers();
  value_into(value, result, as_real);
  store_variable(symbol, result, value.place);
  code_.release(mark);
}

void ExpressionCompiler::call(const Expr& expression) {
  begin(expression);
  const auto mark = code_.mark();
  call_routine(std::get<Call>(expression.node), expression);
  code_.release(mark);
}

/// The arguments lie where the routine's registers will begin, and there its value is left. All
/// that the caller still needs lies below.
Register ExpressionCompiler::call_routine(const Call& call, const Expr& expression) {
  const auto parameters = parameters_of(*call.routine);
  int texts = is_text(call.routine->result) ? 1 : 0;
  int numbers = 1 - texts;
  const int text_count = static_cast<int>(
      std::ranges::count_if(parameters, [](const Parameter& one) { return one.is_text(); }));
  texts = std::max(texts, text_count);
  numbers = std::max(numbers, static_cast<int>(parameters.size()) - text_count);
  const Register first = code_.number_registers(numbers);
  const Register first_text = code_.text_registers(texts);
  Register next = first;
  Register next_text = first_text;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Routine::Parameters& group = *parameters[i].group;
    const Expr& argument = call.bound[i] != nullptr ? *call.bound[i] : *group.value;
    const Register target = parameters[i].is_text() ? next_text++ : next++;
    if (group.by_reference) {
      refer(*std::get<Name>(argument.node).symbol, target, argument.place);
    } else {
      into(argument, target, group.type.kind == Type::Kind::Real);
    }
  }
  code_.call(call.routine->index, first, first_text, expression.place);
  // The routine's own observations come in between: what follows belongs to a new instant.
  if (latched_) code_.emit(Opcode::latch, expression.place);
  return is_text(call.routine->result) ? first_text : first;
}

}  // namespace rob::lang
