#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "lang/check/called_builtins.h"
#include "lang/check/fold.h"
#include "lang/check/observations.h"
#include "lang/check/routine.h"
#include "lang/compile/expression_compiler.h"
#include "lang/values/builtins.h"

/// Values: what ends up in a register.
namespace rob::lang {
namespace {

bool is_truth(const Expr& expression) { return expression.type.kind == Type::Kind::Bool; }

}  // namespace

/// What is no variable is read anew each time; in a watch its value was fixed before.
bool ExpressionCompiler::lives_in_register(const Symbol& symbol) const {
  if (symbol.kind == Symbol::Kind::BuiltIn) return watching_;
  if (symbol.kind == Symbol::Kind::Reading) return watching_ && !is_observation(symbol.reading);
  return symbol.kind != Symbol::Kind::Signal;
}

void ExpressionCompiler::begin(const Expr& expression) {
  latched_ = observations(expression) > 1;
  if (latched_) code_.emit(Opcode::latch, expression.place);
  refresh(observed_globals(expression), expression.place);
}

void ExpressionCompiler::value_into(const Expr& expression, Register target, bool as_real) {
  begin(expression);
  into(expression, target, as_real);
}

Register ExpressionCompiler::value(const Expr& expression, bool as_real) {
  begin(expression);
  return operand(expression, as_real);
}

void ExpressionCompiler::append_value(const Expr& expression, Register text) {
  begin(expression);
  append(expression, text);
}

Register ExpressionCompiler::result_register(const Type& type) {
  const Location fresh = temporary(type, {});
  return type.kind == Type::Kind::String ? fresh.texts.reg() : fresh.numbers.reg();
}

Register ExpressionCompiler::operand(const Expr& expression, bool as_real) {
  const bool convert = (as_real && expression.type == Type::integer()) ||
                       numbers_of(expression) > slots_of(expression.type).numbers;
  if (!convert && expression.moved_from == nullptr && is_number_element(expression)) {
    const Register target = code_.number_registers();
    load_element(std::get<Index>(expression.node), target, expression.place);
    return target;
  }
  if (!convert && expression.moved_from == nullptr && is_variable(expression)) {
    const Location at = locate(expression);
    const SlotsAt& part = expression.type.text() ? at.texts : at.numbers;
    if (part.in_register()) return part.reg();
    const Register target = result_register(expression.type);
    load(at, expression.type, target, expression.place);
    return target;
  }
  // What a routine returns stays where the call has left it.
  if (const auto* const call = std::get_if<Call>(&expression.node);
      call != nullptr && call->routine != nullptr && !convert && expression.moved_from == nullptr) {
    const Location result = call_routine(*call, expression);
    return expression.type.text() ? result.texts.reg() : result.numbers.reg();
  }
  const Register target = expression.place_slots != 0
                              ? code_.number_registers(expression.place_slots)
                              : result_register(expression.type);
  into(expression, target, as_real);
  return target;
}

Register ExpressionCompiler::operand_before(const Expr& then, const Expr& expression,
                                            bool as_real) {
  if (!calls_routine(then) || !is_variable(expression)) return operand(expression, as_real);
  const Register target = result_register(expression.type);
  into(expression, target, as_real);
  return target;
}

void ExpressionCompiler::into(const Expr& expression, Register target, bool as_real) {
  const auto mark = code_.mark();
  if (expression.place_slots != 0) {
    into_other_place(expression, target);
  } else if (expression.moved_from != nullptr) {
    into_world(expression, target);
  } else {
    into_as_it_is(expression, target, as_real);
  }
  code_.release(mark);
}

void ExpressionCompiler::into_as_it_is(const Expr& expression, Register target, bool as_real) {
  if (known(expression.constant)) {
    load(expression, target, as_real);
  } else if (as_real && expression.type == Type::integer()) {
    code_.emit(Opcode::int_to_real, expression.place, target, operand(expression, false));
  } else if (const auto* const name = std::get_if<Name>(&expression.node)) {
    compile(*name, expression, target);
  } else if (const auto* const member = std::get_if<Member>(&expression.node);
             member != nullptr && angle_of(member->object->type, member->field)) {
    compile_angle(*member, target, expression.place);
  } else if (is_number_element(expression)) {
    load_element(std::get<Index>(expression.node), target, expression.place);
  } else if (std::holds_alternative<Member>(expression.node) ||
             std::holds_alternative<Index>(expression.node)) {
    load(locate(expression), expression.type, target, expression.place);
  } else if (const auto* const tuple = std::get_if<Tuple>(&expression.node)) {
    compile(*tuple, target);
  } else if (const auto* const call = std::get_if<Call>(&expression.node)) {
    compile(*call, expression, target);
  } else if (is_truth(expression)) {
    compile_truth(expression, target);
  } else if (const auto* const unary = std::get_if<Unary>(&expression.node)) {
    compile(*unary, expression, target);
  } else {
    compile(std::get<Binary>(expression.node), expression, target);
  }
}

void ExpressionCompiler::load(const Expr& expression, Register target, bool as_real) {
  const Constant constant =
      as_real ? converted(expression.constant, Type::real()) : expression.constant;
  if (const auto* const text = std::get_if<std::string>(&constant)) {
    code_.load_text(target, *text, expression.place);
  } else if (const auto* const real = std::get_if<double>(&constant)) {
    code_.load_real(target, *real, expression.type.dimension, expression.place);
  } else if (const auto* const compound = std::get_if<std::vector<double>>(&constant)) {
    for (const double part : *compound) {
      code_.load_real(target++, part, expression.type.dimension, expression.place);
    }
  } else {
    code_.load_integer(target, to_slot(constant).integer, expression.place);
  }
}

void ExpressionCompiler::compile(const Name& name, const Expr& expression, Register target) {
  const Symbol& symbol = *name.symbol;
  if (symbol.kind == Symbol::Kind::Signal) {
    read_signal(symbol, target, expression.place);
  } else if (symbol.kind == Symbol::Kind::Reading) {
    read(symbol.reading, target, expression.place);
  } else if (!lives_in_register(symbol)) {
    code_.emit(Opcode::read_hit, expression.place, target);
  } else {
    load(home(symbol), expression.type, target, expression.place);
  }
}

void ExpressionCompiler::compile(const Call& call, const Expr& expression, Register target) {
  if (call.routine != nullptr) {
    const Location result = call_routine(call, expression);
    return load(result, expression.type, target, expression.place);
  }
  const Builtin& builtin = *find_builtin(call);
  if (builtin.rule == BuiltinRule::AnyToText) {
    const Register text = code_.text_register();
    code_.load_text(text, "", expression.place);
    append(*call.arguments.front(), text);
    code_.emit(Opcode::copy_text, expression.place, target, text);
    return;
  }
  if (const auto reading = reading_of(call)) return read(*reading, target, expression.place);
  if (builtin.rule == BuiltinRule::Joints) return compile_joints(call, expression, target);
  if (builtin.rule == BuiltinRule::Forward) return compile_forward(call, expression, target);
  if (builtin.rule == BuiltinRule::ArrayLength) {
    const Expr& array = *call.arguments.front();
    locate(array);
    return code_.load_integer(target, array.type.detail->length, expression.place);
  }
  if (builtin.rule == BuiltinRule::Random) return draw(call, expression, target);
  if (builtin.rule == BuiltinRule::Texts) return call_on_texts(builtin, call, expression, target);
  const bool whole = computes_whole(builtin, call);
  int given = 0;
  for (const ExprPtr& argument : call.arguments) given += numbers_of(*argument);
  const int results = slots_of(expression.type).numbers;
  const Register first = code_.number_registers(std::max(given, results));
  Register next = first;
  for (const ExprPtr& argument : call.arguments) {
    into(*argument, next, !whole);
    next = static_cast<Register>(next + numbers_of(*argument));
  }
  const auto index = static_cast<unsigned>(&builtin - builtins().data());
  code_.emit(whole ? Opcode::call_int : Opcode::call_real, expression.place, first, index,
             static_cast<unsigned>(given));
  copy_registers(target, first, results, expression.place);
}

void ExpressionCompiler::draw(const Call& call, const Expr& expression, Register target) {
  code_.depends_on_time();  // each look draws anew
  if (call.arguments.empty()) {
    code_.emit(Opcode::random, expression.place, target);
    return;
  }
  const bool whole = expression.type == Type::integer();
  const Register bounds = code_.number_registers(2);
  into(*call.arguments[0], bounds, !whole);
  into(*call.arguments[1], static_cast<Register>(bounds + 1), !whole);
  code_.emit(whole ? Opcode::random_int : Opcode::random_real, expression.place, bounds);
  code_.emit(Opcode::copy, expression.place, target, bounds);
}

/// Numbers and texts lie apart, each in order; the result takes the place of the first of its kind.
void ExpressionCompiler::call_on_texts(const Builtin& builtin, const Call& call,
                                       const Expr& expression, Register target) {
  const std::string_view parameters = builtin.signature.parameters;
  const auto count = static_cast<int>(parameters.size());
  const Register numbers = code_.number_registers(count);
  const Register texts = code_.text_registers(count);
  Register next = numbers;
  Register next_text = texts;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    into(*call.arguments[i], parameters[i] == 'S' ? next_text++ : next++, parameters[i] == 'Q');
  }
  const auto index = static_cast<unsigned>(&builtin - builtins().data());
  code_.emit(Opcode::call_text, expression.place, numbers, texts, index);
  code_.emit(expression.type.text() ? Opcode::copy_text : Opcode::copy, expression.place, target,
             expression.type.text() ? texts : numbers);
}

void ExpressionCompiler::append(const Expr& expression, Register text) {
  if (!expression.type.scalar()) return append_compound(expression, text);
  const auto mark = code_.mark();
  append_register(operand(expression, false), expression.type, false, text, expression.place);
  code_.release(mark);
}

void ExpressionCompiler::append_register(Register value, const Type& type, bool real, Register text,
                                         Place place) {
  switch (type.kind) {
    case Type::Kind::Bool:
      return code_.emit(Opcode::append_bool, place, text, value);
    case Type::Kind::Int:
      if (real) return code_.append_real(text, value, kNone, place);
      return code_.emit(Opcode::append_int, place, text, value);
    case Type::Kind::Real:
      return code_.append_real(text, value, type.dimension, place);
    default:
      return code_.emit(Opcode::append_text, place, text, value);
  }
}

}  // namespace rob::lang
