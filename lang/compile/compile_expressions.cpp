#include <algorithm>
#include <bit>
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

bool is_text(const Expr& expression) { return expression.type.kind == Type::Kind::String; }

bool is_truth(const Expr& expression) { return expression.type.kind == Type::Kind::Bool; }

Opcode whole_opcode(BinaryOp op) {
  switch (op) {
    case BinaryOp::Add:
      return Opcode::add_int;
    case BinaryOp::Subtract:
      return Opcode::sub_int;
    case BinaryOp::Multiply:
      return Opcode::mul_int;
    case BinaryOp::Div:
      return Opcode::div_int;
    case BinaryOp::Mod:
      return Opcode::mod_int;
    default:
      return Opcode::pow_int;
  }
}

/// The operation with a constant on its right, if there is one.
std::optional<Opcode> constant_opcode(BinaryOp op, bool whole) {
  switch (op) {
    case BinaryOp::Add:
      return whole ? Opcode::add_int_constant : Opcode::add_real_constant;
    case BinaryOp::Subtract:
      return whole ? Opcode::sub_int_constant : Opcode::sub_real_constant;
    case BinaryOp::Multiply:
      return whole ? Opcode::mul_int_constant : Opcode::mul_real_constant;
    case BinaryOp::Divide:
      return whole ? std::nullopt : std::optional(Opcode::quot_real_constant);
    default:
      return std::nullopt;
  }
}

/// Whether an operation works on INT slots. INT / INT is real, and so is INT ^ INT unless the
/// checker says otherwise.
bool on_whole_numbers(const Binary& binary, const Type& result) {
  if (binary.left->type != Type::integer() || binary.right->type != Type::integer()) return false;
  return result.kind == Type::Kind::Int;
}

/// A product of two values that have to be computed, of INTs or of REALs.
const Binary* product_in(const Expr& expression, bool whole) {
  const auto* const product = std::get_if<Binary>(&expression.node);
  const bool found = product != nullptr && product->op == BinaryOp::Multiply &&
                     !known(expression.constant) && !known(product->left->constant) &&
                     !known(product->right->constant) &&
                     on_whole_numbers(*product, expression.type) == whole;
  return found ? product : nullptr;
}

Opcode product_opcode(BinaryOp op, bool whole) {
  if (op == BinaryOp::Add) return whole ? Opcode::add_product_int : Opcode::add_product_real;
  return whole ? Opcode::sub_product_int : Opcode::sub_product_real;
}

}  // namespace

Opcode real_opcode(BinaryOp op) {
  switch (op) {
    case BinaryOp::Add:
      return Opcode::add_real;
    case BinaryOp::Subtract:
      return Opcode::sub_real;
    case BinaryOp::Multiply:
      return Opcode::mul_real;
    case BinaryOp::Divide:
      return Opcode::quot_real;
    case BinaryOp::Div:
      return Opcode::div_real;
    case BinaryOp::Mod:
      return Opcode::mod_real;
    default:
      return Opcode::pow_real;
  }
}

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
    const SlotsAt& part = is_text(expression) ? at.texts : at.numbers;
    if (part.in_register()) return part.reg();
    const Register target = result_register(expression.type);
    load(at, expression.type, target, expression.place);
    return target;
  }
  // What a routine returns stays where the call has left it.
  if (const auto* const call = std::get_if<Call>(&expression.node);
      call != nullptr && call->routine != nullptr && !convert && expression.moved_from == nullptr) {
    const Location result = call_routine(*call, expression);
    return is_text(expression) ? result.texts.reg() : result.numbers.reg();
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

void ExpressionCompiler::compile(const Unary& unary, const Expr& expression, Register target) {
  if (unary.op == UnaryOp::Plus) {
    into(*unary.operand, target, false);
    return;
  }
  if (expression.type.is(Type::Kind::Vec)) return negate_vector(unary, expression, target);
  const Opcode op = expression.type == Type::integer() ? Opcode::neg_int : Opcode::neg_real;
  code_.emit(op, expression.place, target, operand(*unary.operand, false));
}

void ExpressionCompiler::compile(const Binary& binary, const Expr& expression, Register target) {
  if (is_text(expression)) {
    const Register left = operand_before(*binary.right, *binary.left, false);
    const Register right = operand(*binary.right, false);
    code_.emit(Opcode::join_text, expression.place, target, left, right);
    return;
  }
  if (binary.left->type.is_place()) return compile_on_places(binary, expression, target);
  if (expression.type.is(Type::Kind::Vec) || expression.type.is(Type::Kind::Joints)) {
    return compile_vector(binary, expression, target);
  }
  if (compile_by_constant(binary, expression, target)) return;
  if (compile_with_product(binary, expression, target)) return;
  // DIV of reals yields an INT from REAL operands.
  const bool whole = on_whole_numbers(binary, expression.type);
  const Register left = operand_before(*binary.right, *binary.left, !whole);
  const Register right = operand(*binary.right, !whole);
  code_.emit(whole ? whole_opcode(binary.op) : real_opcode(binary.op), expression.place, target,
             left, right);
}

std::optional<std::uint8_t> ExpressionCompiler::constant_operand(const Expr& expression,
                                                                 bool as_real) {
  const Constant constant =
      as_real ? converted(expression.constant, Type::real()) : expression.constant;
  if (const auto* const real = std::get_if<double>(&constant)) {
    return code_.constant_operand(Slot{.real = *real}, std::bit_cast<std::uint64_t>(*real),
                                  Type::real(expression.type.dimension));
  }
  if (const auto* const truth = std::get_if<bool>(&constant)) {
    return code_.constant_operand(to_slot(constant), *truth ? 1 : 0, Type::boolean());
  }
  const auto* const whole = std::get_if<std::int64_t>(&constant);
  if (whole == nullptr) return std::nullopt;
  return code_.constant_operand(Slot{.integer = *whole}, static_cast<std::uint64_t>(*whole),
                                Type::integer());
}

/// An operation with a constant, where there is one: what is on its left may stand on its right
/// where the order is no matter.
bool ExpressionCompiler::compile_by_constant(const Binary& binary, const Expr& expression,
                                             Register target) {
  const bool whole = on_whole_numbers(binary, expression.type);
  const std::optional<Opcode> op = constant_opcode(binary.op, whole);
  if (!op) return false;
  const bool exchanged = known(binary.left->constant);
  if (exchanged && binary.op != BinaryOp::Add && binary.op != BinaryOp::Multiply) return false;
  const Expr& variable = exchanged ? *binary.right : *binary.left;
  const auto constant = constant_operand(exchanged ? *binary.left : *binary.right, !whole);
  if (!constant) return false;
  code_.emit(*op, expression.place, target, operand(variable, !whole), *constant);
  return true;
}

bool ExpressionCompiler::stays_in_register(const Expr& expression) const {
  const auto* const name = std::get_if<Name>(&expression.node);
  return name != nullptr && is_variable(expression) && home(*name->symbol).numbers.in_register();
}

/// What is added to a product on its left is read behind it, so it has to be there already: what
/// could fail would have to wait for the product.
bool ExpressionCompiler::compile_with_product(const Binary& binary, const Expr& expression,
                                              Register target) {
  if (watching_ || (binary.op != BinaryOp::Add && binary.op != BinaryOp::Subtract)) return false;
  const bool whole = on_whole_numbers(binary, expression.type);
  const Expr* factors = binary.right.get();
  const Binary* product = product_in(*factors, whole);
  const bool exchanged = product == nullptr;
  if (exchanged) {
    const bool whole_right = binary.right->type == Type::integer();
    factors = binary.left.get();
    product = product_in(*factors, whole);
    if (product == nullptr || binary.op != BinaryOp::Add || whole_right != whole ||
        !stays_in_register(*binary.right)) {
      return false;
    }
  }
  Register term = exchanged ? 0 : operand_before(*factors, *binary.left, !whole);
  const Register first = operand_before(*product->right, *product->left, !whole);
  const Register second = operand(*product->right, !whole);
  if (exchanged) term = operand(*binary.right, !whole);
  code_.emit(product_opcode(binary.op, whole), factors->place, target, term, first);
  code_.emit(Instruction{second}, expression.place);
  return true;
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
  code_.emit(is_text(expression) ? Opcode::copy_text : Opcode::copy, expression.place, target,
             is_text(expression) ? texts : numbers);
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
