#include <algorithm>
#include <vector>

#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/compile/expression_compiler.h"
#include "lang/compile/fixed_parts.h"
#include "lang/compile/operations.h"
#include "lang/compile/texts_in_place.h"

/// Member functions of ExpressionCompiler for conditions, which become jumps. AND and OR decide as
/// soon as one side settles the matter.
namespace rob::lang {
CodeBuilder::Jumps ExpressionCompiler::jumps_if(const Expr& condition, bool when) {
  begin(condition);
  return jumps(condition, when);
}

CodeBuilder::Jump ExpressionCompiler::jump_if_equal(Register selector, const Expr& value,
                                                    bool as_real) {
  begin(value);
  const auto mark = frame_.mark();
  CodeBuilder::Jump result = 0;
  if (const auto* const text = std::get_if<std::string>(&value.constant)) {
    result = compare_known_text(code_, BinaryOp::Equal, selector, *text, true, value.place);
    frame_.release(mark);
    return result;
  }
  const Register other = operand(value, as_real);
  if (value.type.kind == Type::Kind::String) {
    const Register truth = frame_.number_registers();
    code_.emit(Opcode::equal_text, value.place, truth, selector, other);
    result = jump_if(code_, truth, true, value.place);
  } else {
    code_.emit(as_real ? Opcode::if_equal_real : Opcode::if_equal_int, value.place, selector, other,
               1);
    result = code_.jump(value.place);
  }
  frame_.release(mark);
  return result;
}

std::optional<ExpressionCompiler::Compared> ExpressionCompiler::compare(const Expr& condition) {
  const auto* const binary = std::get_if<Binary>(&condition.node);
  const bool comparison =
      binary != nullptr && binary->op >= BinaryOp::Equal && binary->op <= BinaryOp::GreaterEqual;
  if (!comparison || known(condition.constant) || !binary->left->type.scalar()) {
    return std::nullopt;
  }
  begin(condition);
  const bool real = compares_reals(*binary);
  Compared compared{{}, operand_before(*binary->right, *binary->left, real), 0, real};
  compared.right = operand(*binary->right, real);
  compared.holds =
      binary->left->type.kind == Type::Kind::String
          ? compare_texts(code_, binary->op, compared.left, compared.right, true, condition.place)
          : compare_numbers(code_, *binary, compared.left, compared.right, true, condition.place);
  return compared;
}

CodeBuilder::Jumps ExpressionCompiler::jumps(const Expr& condition, bool when) {
  if (const bool* const constant = std::get_if<bool>(&condition.constant)) {
    if (*constant == when) return {code_.jump(condition.place)};
    return {};
  }
  if (const auto* const unary = std::get_if<Unary>(&condition.node)) {
    return jumps(*unary->operand, !when);
  }
  const auto mark = frame_.mark();
  CodeBuilder::Jumps result;
  const auto* const binary = std::get_if<Binary>(&condition.node);
  if (binary == nullptr) {
    result = {jump_if(code_, operand(condition, false), when, condition.place)};
  } else if (binary->op == BinaryOp::And || binary->op == BinaryOp::Or) {
    result = jumps_of_logical(*binary, when);
  } else if (binary->left->type.text()) {
    result = jumps_of_texts(code_, *this, *binary, when, condition.place);
  } else if (!binary->left->type.scalar()) {
    result = jumps_of_compounds(*binary, when, condition.place);
  } else {
    result = jumps_of_comparison(*binary, when, condition.place);
  }
  frame_.release(mark);
  return result;
}

CodeBuilder::Jumps ExpressionCompiler::jumps_of_logical(const Binary& binary, bool when) {
  const bool settling = binary.op == BinaryOp::Or;
  if (when == settling) {
    CodeBuilder::Jumps taken = jumps(*binary.left, when);
    const CodeBuilder::Jumps more = jumps(*binary.right, when);
    taken.insert(taken.end(), more.begin(), more.end());
    return taken;
  }
  const CodeBuilder::Jumps settled = jumps(*binary.left, settling);
  CodeBuilder::Jumps taken = jumps(*binary.right, when);
  code_.land(settled);
  return taken;
}

CodeBuilder::Jumps ExpressionCompiler::jumps_of_comparison(const Binary& binary, bool when,
                                                           Place place) {
  const bool real = compares_reals(binary);
  if (binary.op != BinaryOp::Xor) {
    const bool exchanged = known(binary.left->constant);
    const Expr& constant = exchanged ? *binary.left : *binary.right;
    if (const auto operand_index = constant_operand(code_, constant, real)) {
      const Register variable = operand(exchanged ? *binary.right : *binary.left, real);
      return compare_constant(code_, binary, variable, *operand_index, exchanged, when, place);
    }
  }
  const Register left = operand_before(*binary.right, *binary.left, real);
  const Register right = operand(*binary.right, real);
  return compare_numbers(code_, binary, left, right, when, place);
}

/// There is no -0 and nothing that is not a number, so values are equal where their slots are.
CodeBuilder::Jumps ExpressionCompiler::jumps_of_compounds(const Binary& binary, bool when,
                                                          Place place) {
  if (!binary.left->type.in_registers()) return jumps_of_memory(binary, when, place);
  const int count = slots_of(binary.left->type).numbers;
  Register left = 0;
  if (calls_routine(*binary.right)) {
    left = variables_.registers_for(binary.left->type);
    into(*binary.left, left, false);
  } else {
    left = operand(*binary.left, false);
  }
  const Register right = operand(*binary.right, false);
  const Register truth = frame_.number_registers();
  code_.emit(Opcode::equal_block, place, truth, left, right);
  code_.emit(Instruction{static_cast<std::uint32_t>(count)}, place);
  return {jump_if(code_, truth, when == (binary.op == BinaryOp::Equal), place)};
}

CodeBuilder::Jumps ExpressionCompiler::jumps_of_memory(const Binary& binary, bool when,
                                                       Place place) {
  const bool left_list = std::holds_alternative<List>(binary.left->node);
  const Type& type = left_list ? binary.right->type : binary.left->type;
  const Location left = located_as(*binary.left, type, calls_routine(*binary.right));
  const Location right = located_as(*binary.right, type, false);
  const Slots slots = slots_of(type);
  const Register places = frame_.number_registers(3);
  const auto other = static_cast<Register>(places + 1);
  const auto truth = static_cast<Register>(places + 2);
  if (type.is(Type::Kind::List)) {
    variables_.refer(left.numbers, false, places, place);
    variables_.refer(right.numbers, false, other, place);
    code_.emit(Opcode::equal_lists, place, truth, places, other);
    return {jump_if(code_, truth, when == (binary.op == BinaryOp::Equal), place)};
  }
  CodeBuilder::Jumps settled;
  const auto compare = [&](Opcode opcode, const SlotsAt& a, const SlotsAt& b, int count) {
    const bool text = opcode == Opcode::equal_texts;
    variables_.refer(a, text, places, place);
    variables_.refer(b, text, other, place);
    code_.emit(opcode, place, truth, places, other);
    code_.emit(Instruction{static_cast<std::uint32_t>(count)}, place);
  };
  if (slots.numbers > 0) {
    compare(Opcode::equal_memory, left.numbers, right.numbers, slots.numbers);
    if (slots.texts > 0) settled.push_back(jump_if(code_, truth, false, place));
  }
  if (slots.texts > 0) compare(Opcode::equal_texts, left.texts, right.texts, slots.texts);
  code_.land(settled);
  return {jump_if(code_, truth, when == (binary.op == BinaryOp::Equal), place)};
}

/// Their values lie side by side, in the watch as in the frame that sets it up.
ExpressionCompiler::WatchCode ExpressionCompiler::watch(const Expr& condition) {
  const std::vector<const Expr*> fixed = fixed_parts_of(condition);
  const Place place = condition.place;
  world_.begin(0, place);
  variables_.refresh(observed_globals(condition), false, place);
  int count = 0;
  for (const Expr* const part : fixed) count += slots_of(part->type).numbers;
  const Register values = frame_.number_registers(std::max(count, 1));
  Register next = values;
  for (const Expr* const part : fixed) {
    into_as_it_is(*part, next, false);
    next = behind(next, slots_of(part->type).numbers);
  }
  variables_.begin_watch(fixed, place);
  world_.begin(0, place);
  const Register answer = operand(condition, false);
  variables_.end_watch();
  return {code_.end_watch(answer, count, place), values};
}

}  // namespace rob::lang
