#include <algorithm>

#include "lang/check/routine.h"
#include "lang/compile/expression_compiler.h"

/// Member functions of ExpressionCompiler for values in the memory of a frame: how arrays and
/// records are made and copied.
namespace rob::lang {
namespace {

using Base = SlotsAt::Base;

Instruction word(std::uint32_t value) { return {value}; }
Instruction word(std::int64_t value) { return {static_cast<std::uint32_t>(value)}; }

}  // namespace

Location ExpressionCompiler::memory(Slots slots, Place place) {
  const Slots offset = code_.take_memory(slots, place);
  const Register base = code_.memory_register();
  return {{Base::Place, static_cast<std::uint32_t>(offset.numbers), base},
          {Base::Place, static_cast<std::uint32_t>(offset.texts), static_cast<Register>(base + 1)}};
}

/// The memory of the top level lies where it is known to lie; so a routine loads that place.
SlotsAt ExpressionCompiler::reached(SlotsAt at, bool text, Place place) {
  if (at.base != Base::GlobalMemory) return at;
  const Register absolute = code_.number_registers();
  const std::size_t first = (text ? kTextStack : kNumberStack) + at.offset;
  code_.load_integer(absolute, static_cast<std::int64_t>(first), place);
  return {Base::Place, 0, absolute};
}

Location ExpressionCompiler::reached(const Location& home, const Type& type, Place place) {
  const Slots slots = slots_of(type);
  return {slots.numbers > 0 ? reached(home.numbers, false, place) : SlotsAt{},
          slots.texts > 0 ? reached(home.texts, true, place) : SlotsAt{}};
}

void ExpressionCompiler::initialise(const Expr& value, const Location& home, const Type& type) {
  begin(value);
  put(value, home, type);
}

void ExpressionCompiler::put(const Expr& value, const Location& to, const Type& type) {
  const auto mark = code_.mark();
  const Place place = value.place;
  if (type.in_registers()) {
    const SlotsAt& part = type.text() ? to.texts : to.numbers;
    const bool as_real = type.is(Type::Kind::Real);
    if (part.in_register()) {
      into(value, part.reg(), as_real);
    } else {
      store(to, type, operand(value, as_real), place);
    }
  } else if (const auto* const list = std::get_if<List>(&value.node)) {
    const Type& element = type.detail->element;
    Location next = to;
    for (const ExprPtr& each : list->elements) {
      put(*each, next, element);
      next = next.behind(slots_of(element));
    }
  } else if (const auto* const call = std::get_if<Call>(&value.node);
             call != nullptr && call->record != nullptr) {
    put_record(*call, to, place);
  } else {
    copy_memory(to, locate(value), slots_of(type), place);
  }
  code_.release(mark);
}

void ExpressionCompiler::put_record(const Call& call, const Location& to, Place place) {
  Location next = to;
  for (std::size_t i = 0; i < call.bound.size(); ++i) {
    const Type& type = call.record->fields[i].type;
    if (call.bound[i] != nullptr) {
      put(*call.bound[i], next, type);
    } else {
      clear(next, type, place);
    }
    next = next.behind(slots_of(type));
  }
}

/// 0, FALSE, 0.0 have the same bits; texts become "".
void ExpressionCompiler::clear(const Location& home, const Type& type, Place place) {
  const Slots slots = slots_of(type);
  if (slots.numbers > 0 && home.numbers.in_register()) {
    for (int i = 0; i < slots.numbers; ++i) {
      code_.load_integer(home.numbers.behind(i).reg(), 0, place);
    }
  } else if (slots.numbers > 0) {
    code_.emit(Opcode::clear_memory, place, home.numbers.place);
    code_.emit(word(home.numbers.offset), place);
    code_.emit(word(std::int64_t{slots.numbers}), place);
  }
  if (slots.texts > 0 && home.texts.in_register()) {
    code_.load_text(home.texts.reg(), "", place);
  } else if (slots.texts > 0) {
    code_.emit(Opcode::clear_texts, place, home.texts.place);
    code_.emit(word(home.texts.offset), place);
    code_.emit(word(std::int64_t{slots.texts}), place);
  }
}

void ExpressionCompiler::copy_memory(const Location& to, const Location& from, Slots slots,
                                     Place place) {
  const auto copy = [&](Opcode opcode, const SlotsAt& target, const SlotsAt& source, int count) {
    if (count == 0) return;
    code_.emit(opcode, place, target.place, source.place);
    code_.emit(word(target.offset), place);
    code_.emit(word(source.offset), place);
    code_.emit(word(std::int64_t{count}), place);
  };
  copy(Opcode::copy_memory, to.numbers, from.numbers, slots.numbers);
  copy(Opcode::copy_texts, to.texts, from.texts, slots.texts);
}

void ExpressionCompiler::copy(const Location& from, const Location& to, const Type& type,
                              Place place) {
  const auto mark = code_.mark();
  if (!type.in_registers()) {
    copy_memory(to, from, slots_of(type), place);
  } else {
    const SlotsAt& part = type.text() ? from.texts : from.numbers;
    Register value = part.reg();
    if (!part.in_register()) {
      value = result_register(type);
      load(from, type, value, place);
    }
    store(to, type, value, place);
  }
  code_.release(mark);
}

/// A whole array or record. What is built of parts may use the old value, so it is built apart.
void ExpressionCompiler::assign_memory(const Expr& target, const Expr& value) {
  const Slots slots = slots_of(target.type);
  Location from;
  begin(value);
  if (is_variable(value) && !calls_routine(target)) {
    from = locate(value);
  } else {
    from = memory(slots, value.place);
    put(value, from, target.type);
  }
  begin_place(target);
  const Location to = locate(target);
  copy_memory(to, from, slots, target.place);
  if (root_of(target)->symbol->shared) publish(to, target.type, target.place);
}

bool ExpressionCompiler::is_number_element(const Expr& expression) const {
  if (watching_) return false;  // it was fixed before
  const auto* const index = std::get_if<Index>(&expression.node);
  return index != nullptr && index->object->type.is(Type::Kind::Array) &&
         expression.type.scalar() && !expression.type.text() &&
         !std::holds_alternative<std::int64_t>(index->index->constant);
}

void ExpressionCompiler::load_element(const Index& index, Register target, Place place) {
  const auto mark = code_.mark();
  const SlotsAt whole = locate(*index.object).numbers;
  code_.emit(Opcode::load_element, place, target, operand(*index.index, false), whole.place);
  code_.emit(word(whole.offset), place);
  code_.emit(word(index.object->type.detail->length), place);
  code_.release(mark);
}

void ExpressionCompiler::store_element(Opcode opcode, const Index& index, std::uint8_t value,
                                       Place place) {
  const SlotsAt whole = locate(*index.object).numbers;
  code_.emit(opcode, place, value, operand(*index.index, false), whole.place);
  code_.emit(word(whole.offset), place);
  code_.emit(word(index.object->type.detail->length), place);
}

bool ExpressionCompiler::assign_constant_element(const Expr& target, const Expr& value) {
  if (!is_number_element(target) || root_of(target)->symbol->shared) return false;
  const auto constant = constant_operand(value, target.type.is(Type::Kind::Real));
  if (!constant) return false;
  begin_place(target);
  store_element(Opcode::store_element_constant, std::get<Index>(target.node), *constant,
                target.place);
  return true;
}

/// Places of a whole value in two registers, that of its numbers and that of its texts.
Register ExpressionCompiler::refer_whole(const Expr& expression) {
  const Slots slots = slots_of(expression.type);
  const Register first = code_.number_registers(2);
  const Location at = locate(expression);
  if (slots.numbers > 0) refer(at.numbers, false, first, expression.place);
  if (slots.texts > 0) refer(at.texts, true, static_cast<Register>(first + 1), expression.place);
  return first;
}

/// Where a value lies that a type is wanted of: lists take it.
Location ExpressionCompiler::located_as(const Expr& expression, const Type& type, bool keep) {
  if (is_variable(expression) && !keep) return locate(expression);
  const Location fresh = memory(slots_of(type), expression.place);
  put(expression, fresh, type);
  return fresh;
}

CodeBuilder::Jumps ExpressionCompiler::jumps_of_memory(const Binary& binary, bool when,
                                                       Place place) {
  const bool left_list = std::holds_alternative<List>(binary.left->node);
  const Type& type = left_list ? binary.right->type : binary.left->type;
  const Location left = located_as(*binary.left, type, calls_routine(*binary.right));
  const Location right = located_as(*binary.right, type, false);
  const Slots slots = slots_of(type);
  const Register places = code_.number_registers(3);
  const auto other = static_cast<Register>(places + 1);
  const auto truth = static_cast<Register>(places + 2);
  CodeBuilder::Jumps settled;
  const auto compare = [&](Opcode opcode, const SlotsAt& a, const SlotsAt& b, int count) {
    const bool text = opcode == Opcode::equal_texts;
    refer(a, text, places, place);
    refer(b, text, other, place);
    code_.emit(opcode, place, truth, places, other);
    code_.emit(word(std::int64_t{count}), place);
  };
  if (slots.numbers > 0) {
    compare(Opcode::equal_memory, left.numbers, right.numbers, slots.numbers);
    if (slots.texts > 0) settled.push_back(jump_if(truth, false, place));
  }
  if (slots.texts > 0) compare(Opcode::equal_texts, left.texts, right.texts, slots.texts);
  code_.land(settled);
  return {jump_if(truth, when == (binary.op == BinaryOp::Equal), place)};
}

}  // namespace rob::lang
