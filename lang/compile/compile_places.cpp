#include "lang/check/fold.h"
#include "lang/check/routine.h"
#include "lang/compile/expression_compiler.h"

/// Member functions of ExpressionCompiler for the places of values: registers, the memory of a
/// frame, or where a reference points. They also move values between these.
namespace rob::lang {
namespace {

using Base = SlotsAt::Base;

/// The instruction's word that holds an offset or a count.
Instruction operand_word(std::uint32_t value) { return {value}; }

}  // namespace

Location ExpressionCompiler::home(const Symbol& symbol) const {
  Location home = homes_[symbol.id];
  if (watching_ || !in_routine_ || !symbol.global) return home;
  for (SlotsAt* const at : {&home.numbers, &home.texts}) {
    if (at->base == Base::Own) {
      at->base = Base::GlobalRegister;
    } else {
      at->base = Base::GlobalMemory;
    }
  }
  return home;
}

bool ExpressionCompiler::is_variable(const Expr& expression) const {
  if (known(expression.constant)) return false;
  if (const auto* const member = std::get_if<Member>(&expression.node)) {
    if (angle_of(member->object->type, member->field)) return false;
  }
  const Name* const root = root_of(expression);
  return root != nullptr && lives_in_register(*root->symbol) && !known(root->symbol->value);
}

Location ExpressionCompiler::locate(const Expr& expression) {
  for (const auto& [part, location] : fixed_parts_) {
    if (part == &expression) return location;
  }
  if (!known(expression.constant)) {
    if (const auto* const name = std::get_if<Name>(&expression.node)) {
      if (lives_in_register(*name->symbol)) {
        return reached(home(*name->symbol), expression.type, expression.place);
      }
    }
    if (const auto* const member = std::get_if<Member>(&expression.node)) {
      const auto field = field_of(member->object->type, member->field);
      if (field) return locate(*member->object).behind(field->offset);
    }
    if (const auto* const index = std::get_if<Index>(&expression.node)) return element(*index);
  }
  if (const auto* const call = std::get_if<Call>(&expression.node);
      call != nullptr && call->routine != nullptr && !expression.type.in_registers()) {
    return call_routine(*call, expression);
  }
  const Location fresh = temporary(expression.type, expression.place);
  if (!expression.type.in_registers()) {
    put(expression, fresh, expression.type);
    return fresh;
  }
  into(expression, expression.type.text() ? fresh.texts.reg() : fresh.numbers.reg(), false);
  return fresh;
}

Location ExpressionCompiler::temporary(const Type& type, Place place) {
  const Slots slots = slots_of(type);
  if (!type.in_registers()) return memory(slots, place);
  Location fresh;
  if (slots.numbers > 0) fresh.numbers.offset = code_.number_registers(slots.numbers);
  if (slots.texts > 0) fresh.texts.offset = code_.text_registers(slots.texts);
  return fresh;
}

Location ExpressionCompiler::element(const Index& index) {
  const Elements elements = *elements_of(index.object->type);
  const Slots size = slots_of(elements.type);
  const Location whole = locate(*index.object);
  if (const auto* const number = std::get_if<std::int64_t>(&index.index->constant)) {
    const int before = static_cast<int>(*number) - 1;
    return whole.behind({before * size.numbers, before * size.texts});
  }
  const Register which = operand(*index.index, false);
  const Place place = index.index->place;
  Location result = whole;
  if (size.numbers > 0) {
    result.numbers = element_at(whole.numbers, false, which, elements.count, size.numbers, place);
  }
  if (size.texts > 0) {
    result.texts = element_at(whole.texts, true, which, elements.count, size.texts, place);
  }
  return result;
}

SlotsAt ExpressionCompiler::element_at(SlotsAt whole, bool text, Register which, std::int64_t count,
                                       int size, Place place) {
  const Register at = code_.number_registers();
  if (whole.base != Base::Place) {
    refer(whole, text, at, place);
    whole = {Base::Place, 0, at};
  }
  code_.emit(Opcode::element, place, at, which, whole.place);
  code_.emit(operand_word(whole.offset), place);
  code_.emit(operand_word(static_cast<std::uint32_t>(count)), place);
  code_.emit(operand_word(static_cast<std::uint32_t>(size)), place);
  return {Base::Place, 0, at};
}

/// The place on the stack. The frame of the top level is the first, so there a register's number
/// is its place.
void ExpressionCompiler::refer(SlotsAt at, bool text, Register target, Place place) {
  switch (at.base) {
    case Base::Own:
      return code_.emit(text ? Opcode::refer_text : Opcode::refer, place, target, at.reg());
    case Base::GlobalRegister:
      return code_.load_integer(target, at.offset, place);
    case Base::GlobalMemory:
      return refer(reached(at, text, place), text, target, place);
    case Base::Place:
      if (at.offset == 0) return code_.emit(Opcode::copy, place, target, at.place);
      code_.emit(Opcode::place_behind, place, target, at.place);
      code_.emit(operand_word(at.offset), place);
      return;
  }
}

void ExpressionCompiler::load_numbers(SlotsAt from, Register target, int count, Place place) {
  switch (from.base) {
    case Base::Own:
      return copy_registers(target, from.reg(), count, place);
    case Base::GlobalRegister:
      for (int i = 0; i < count; ++i) {
        code_.emit(Instruction::ax(Opcode::load_global, static_cast<Register>(target + i),
                                   from.offset + static_cast<unsigned>(i)),
                   place);
      }
      return;
    case Base::GlobalMemory:
      return load_numbers(reached(from, false, place), target, count, place);
    case Base::Place:
      code_.emit(Opcode::load_reference, place, target, from.place, static_cast<unsigned>(count));
      code_.emit(operand_word(from.offset), place);
      return;
  }
}

void ExpressionCompiler::store_numbers(SlotsAt to, Register value, int count, Place place) {
  switch (to.base) {
    case Base::Own:
      return copy_registers(to.reg(), value, count, place);
    case Base::GlobalRegister:
      for (int i = 0; i < count; ++i) {
        code_.emit(Instruction::ax(Opcode::store_global, static_cast<Register>(value + i),
                                   to.offset + static_cast<unsigned>(i)),
                   place);
      }
      return;
    case Base::GlobalMemory:
      return store_numbers(reached(to, false, place), value, count, place);
    case Base::Place:
      code_.emit(Opcode::store_reference, place, value, to.place, static_cast<unsigned>(count));
      code_.emit(operand_word(to.offset), place);
      return;
  }
}

void ExpressionCompiler::copy_registers(Register to, Register from, int count, Place place) {
  if (to == from) return;
  if (count == 1) return code_.emit(Opcode::copy, place, to, from);
  code_.emit(Opcode::copy_block, place, to, from, static_cast<unsigned>(count));
}

void ExpressionCompiler::load_text(SlotsAt from, Register target, Place place) {
  switch (from.base) {
    case Base::Own:
      return code_.emit(Opcode::copy_text, place, target, from.reg());
    case Base::GlobalRegister:
      return code_.emit(Instruction::ax(Opcode::load_global_text, target, from.offset), place);
    case Base::GlobalMemory:
      return load_text(reached(from, true, place), target, place);
    case Base::Place:
      code_.emit(Opcode::load_reference_text, place, target, from.place);
      code_.emit(operand_word(from.offset), place);
      return;
  }
}

void ExpressionCompiler::store_text(SlotsAt to, Register value, Place place) {
  switch (to.base) {
    case Base::Own:
      return code_.emit(Opcode::copy_text, place, to.reg(), value);
    case Base::GlobalRegister:
      return code_.emit(Instruction::ax(Opcode::store_global_text, value, to.offset), place);
    case Base::GlobalMemory:
      return store_text(reached(to, true, place), value, place);
    case Base::Place:
      code_.emit(Opcode::store_reference_text, place, value, to.place);
      code_.emit(operand_word(to.offset), place);
      return;
  }
}

void ExpressionCompiler::load(const Location& from, const Type& type, Register target,
                              Place place) {
  if (type.text()) return load_text(from.texts, target, place);
  load_numbers(from.numbers, target, slots_of(type).numbers, place);
}

void ExpressionCompiler::store(const Location& to, const Type& type, Register value, Place place) {
  if (type.text()) return store_text(to.texts, value, place);
  store_numbers(to.numbers, value, slots_of(type).numbers, place);
}

/// The value first, then the place: an index is computed behind it.
void ExpressionCompiler::assign(const Expr& target, const Expr& value) {
  const Type& type = target.type;
  const bool as_real = type.kind == Type::Kind::Real;
  const auto mark = code_.mark();
  if (const auto* const name = std::get_if<Name>(&target.node)) {
    const Location at = home(*name->symbol);
    const SlotsAt& part = type.text() ? at.texts : at.numbers;
    if (type.in_registers() && part.in_register()) {
      value_into(value, part.reg(), as_real);
      return publish(*name->symbol, target.place);
    }
  }
  if (!type.in_registers()) {
    assign_memory(target, value);
    return code_.release(mark);
  }
  if (assign_constant_element(target, value)) return code_.release(mark);
  begin(value);
  assign_register(target, operand_before(target, value, as_real));
  code_.release(mark);
}

void ExpressionCompiler::assign_register(const Expr& target, Register value) {
  const auto mark = code_.mark();
  begin_place(target);
  const bool shared = root_of(target)->symbol->shared;
  if (is_number_element(target) && !shared) {
    store_element(Opcode::store_element, std::get<Index>(target.node), value, target.place);
  } else {
    const Location at = locate(target);
    store(at, target.type, value, target.place);
    if (shared) publish(at, target.type, target.place);
  }
  code_.release(mark);
}

}  // namespace rob::lang
