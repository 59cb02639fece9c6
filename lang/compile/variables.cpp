#include "lang/compile/variables.h"

#include <algorithm>

#include "lang/check/fold.h"

namespace rob::lang {
namespace {

using Base = SlotsAt::Base;

/// The instruction's word that holds an offset or a count.
Instruction operand_word(std::uint32_t value) { return {value}; }
Instruction operand_word(int value) { return {static_cast<std::uint32_t>(value)}; }

}  // namespace

Location Variables::home(const Symbol& symbol) const {
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

bool Variables::has_home(const Symbol& symbol) const {
  if (symbol.kind == Symbol::Kind::BuiltIn) return watching_;
  if (symbol.kind == Symbol::Kind::Reading) return watching_ && !is_observation(symbol.reading);
  return symbol.kind != Symbol::Kind::Signal;
}

bool Variables::is_variable(const Expr& expression) const {
  if (known(expression.constant)) return false;
  if (const auto* const member = std::get_if<Member>(&expression.node)) {
    if (angle_of(member->object->type, member->field)) return false;
  }
  const Name* const root = root_of(expression);
  return root != nullptr && has_home(*root->symbol) && !known(root->symbol->value);
}

bool Variables::stays_in_register(const Expr& expression) const {
  const auto* const name = std::get_if<Name>(&expression.node);
  return name != nullptr && is_variable(expression) && home(*name->symbol).numbers.in_register();
}

bool Variables::is_number_element(const Expr& expression) const {
  if (watching_) return false;  // it was fixed before
  const auto* const index = std::get_if<Index>(&expression.node);
  return index != nullptr && index->object->type.is(Type::Kind::Array) &&
         !index->object->type.is_row() && expression.type.scalar() && !expression.type.text() &&
         !std::holds_alternative<std::int64_t>(index->index->constant);
}

Location Variables::temporary(const Type& type, Place place) {
  const Slots slots = slots_of(type);
  Location fresh;
  if (!type.in_registers()) fresh = memory(slots, place);
  if (type.is(Type::Kind::List)) open_list(fresh, type, place);
  if (!type.in_registers()) return fresh;
  if (slots.numbers > 0) fresh.numbers.offset = frame_.number_registers(slots.numbers);
  if (slots.texts > 0) fresh.texts.offset = frame_.text_registers(slots.texts);
  return fresh;
}

void Variables::open_list(const Location& at, const Type& type, Place place) {
  const auto mark = frame_.mark();
  const Register home = frame_.number_registers();
  const Slots size = slots_of(type.detail->element);
  refer(at.numbers, false, home, place);
  code_.emit(Opcode::open_list, place, home);
  code_.emit(operand_word(size.numbers), place);
  code_.emit(operand_word(size.texts), place);
  frame_.release(mark);
}

void Variables::fill_list(const Location& to, const Location& from, Place place) {
  const auto mark = frame_.mark();
  const Register row = list_row(from, place);
  const Register home = frame_.number_registers();
  refer(to.numbers, false, home, place);
  code_.emit(Opcode::fill_list, place, home, row);
  frame_.release(mark);
}

Register Variables::list_row(const Location& list, Place place) {
  const Register row = frame_.number_registers(3);
  refer(list.numbers, false, row, place);
  code_.emit(Opcode::list_row, place, row, row);
  return row;
}

/// Its first two registers; where there are no such slots, any place will do.
Register Variables::row_at(const Location& at, Slots slots, Place place) {
  const Register first = frame_.number_registers(3);
  const auto refer = [&](const SlotsAt& from, bool text, int count, Register target) {
    if (count == 0) return code_.load_integer(target, 0, place);
    this->refer(from, text, target, place);
  };
  refer(at.numbers, false, slots.numbers, first);
  refer(at.texts, true, slots.texts, behind(first, 1));
  return first;
}

Register Variables::registers_for(const Type& type) {
  const Location fresh = temporary(type, {});
  return type.kind == Type::Kind::String ? fresh.texts.reg() : fresh.numbers.reg();
}

Location Variables::memory(Slots slots, Place place) {
  const Slots offset = frame_.take_memory(slots, place);
  const Register base = frame_.memory_register();
  return {{Base::Place, static_cast<std::uint32_t>(offset.numbers), base},
          {Base::Place, static_cast<std::uint32_t>(offset.texts), static_cast<Register>(base + 1)}};
}

/// The memory of the top level lies where it is known to lie; so a routine loads that place.
SlotsAt Variables::reached(SlotsAt at, bool text, Place place) {
  if (at.base != Base::GlobalMemory) return at;
  const Register absolute = frame_.number_registers();
  const std::size_t first = (text ? kTextStack : kNumberStack) + at.offset;
  code_.load_integer(absolute, static_cast<std::int64_t>(first), place);
  return {Base::Place, 0, absolute};
}

Location Variables::reached(const Location& home, const Type& type, Place place) {
  const Slots slots = slots_of(type);
  return {slots.numbers > 0 ? reached(home.numbers, false, place) : SlotsAt{},
          slots.texts > 0 ? reached(home.texts, true, place) : SlotsAt{}, home.count};
}

void Variables::count(const Location& whole, const Type& type, Register target, Place place) {
  if (type.is_open()) return code_.emit(Opcode::copy, place, target, whole.count);
  if (type.is(Type::Kind::List)) {
    return code_.emit(Opcode::copy, place, target, behind(list_row(whole, place), 2));
  }
  code_.load_integer(target, type.detail->length, place);
}

Location Variables::element(const Location& whole, Register which, const Elements& elements,
                            Place place) {
  const Slots size = slots_of(elements.type);
  Location row = whole;
  if (elements.list) {
    const Register first = list_row(whole, place);
    row = {{Base::Place, 0, first}, {Base::Place, 0, behind(first, 1)}, behind(first, 2)};
  }
  Location result = row;
  if (elements.count == kAnyLength) code_.emit(Opcode::check_index, place, which, row.count);
  if (size.numbers > 0) {
    result.numbers = element_at(row.numbers, false, which, elements.count, size.numbers, place);
  }
  if (size.texts > 0) {
    result.texts = element_at(row.texts, true, which, elements.count, size.texts, place);
  }
  return result;
}

SlotsAt Variables::element_at(SlotsAt whole, bool text, Register which, std::int64_t count,
                              int size, Place place) {
  const Register at = frame_.number_registers();
  if (whole.base != Base::Place) {
    refer(whole, text, at, place);
    whole = {Base::Place, 0, at};
  }
  code_.emit(Opcode::element, place, at, which, whole.place);
  code_.emit(operand_word(whole.offset), place);
  code_.emit(operand_word(static_cast<std::uint32_t>(count)), place);
  code_.emit(operand_word(static_cast<std::uint32_t>(size)), place);
  code_.last_element().ends();
  return {Base::Place, 0, at};
}

/// The place on the stack. The frame of the top level is the first, so there a register's number
/// is its place.
void Variables::refer(SlotsAt at, bool text, Register target, Place place) {
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

void Variables::refer(const Symbol& symbol, bool text, Register target, Place place) {
  const Location at = home(symbol);
  refer(text ? at.texts : at.numbers, text, target, place);
}

void Variables::refer_both(const Location& at, const Type& type, Register numbers, Register texts,
                           Place place) {
  const Slots slots = slots_of(type);
  if (slots.numbers > 0) refer(at.numbers, false, numbers, place);
  if (slots.texts > 0) refer(at.texts, true, texts, place);
}

void Variables::load(const Location& from, const Type& type, Register target, Place place) {
  if (type.text()) return load_text(from.texts, target, place);
  load_numbers(from.numbers, target, slots_of(type).numbers, place);
}

void Variables::store(const Location& to, const Type& type, Register value, Place place) {
  if (type.text()) return store_text(to.texts, value, place);
  store_numbers(to.numbers, value, slots_of(type).numbers, place);
}

void Variables::load_numbers(SlotsAt from, Register target, int count, Place place) {
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
      if (count == 1) return load_slot(from, target, place);
      code_.emit(Opcode::load_reference, place, target, from.place, static_cast<unsigned>(count));
      code_.emit(operand_word(from.offset), place);
      return;
  }
}

void Variables::store_numbers(SlotsAt to, Register value, int count, Place place) {
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
      if (count == 1) return store_slot(to, value, place);
      code_.emit(Opcode::store_reference, place, value, to.place, static_cast<unsigned>(count));
      code_.emit(operand_word(to.offset), place);
      return;
  }
}

void Variables::load_slot(SlotsAt from, Register target, Place place) {
  if (code_.last_element().join(Opcode::load_field, target, from.place, from.offset)) return;
  code_.emit(Opcode::load_slot, place, target, from.place);
  code_.emit(operand_word(from.offset), place);
}

void Variables::store_slot(SlotsAt to, Register value, Place place) {
  if (code_.last_element().join(Opcode::store_field, value, to.place, to.offset)) return;
  code_.emit(Opcode::store_slot, place, value, to.place);
  code_.emit(operand_word(to.offset), place);
}

void Variables::copy_registers(Register to, Register from, int count, Place place) {
  if (to == from) return;
  if (count == 1) return code_.emit(Opcode::copy, place, to, from);
  code_.emit(Opcode::copy_block, place, to, from, static_cast<unsigned>(count));
}

void Variables::load_text(SlotsAt from, Register target, Place place) {
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

void Variables::store_text(SlotsAt to, Register value, Place place) {
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

void Variables::copy(const Location& from, const Location& to, const Type& type, Place place) {
  const auto mark = frame_.mark();
  if (type.is(Type::Kind::List)) {
    fill_list(to, from, place);
  } else if (!type.in_registers()) {
    copy_memory(to, from, slots_of(type), place);
  } else {
    const SlotsAt& part = type.text() ? from.texts : from.numbers;
    Register value = part.reg();
    if (!part.in_register()) {
      value = registers_for(type);
      load(from, type, value, place);
    }
    store(to, type, value, place);
  }
  frame_.release(mark);
}

void Variables::copy_memory(const Location& to, const Location& from, Slots slots, Place place) {
  const auto copy = [&](Opcode opcode, const SlotsAt& target, const SlotsAt& source, int count) {
    if (count == 0) return;
    code_.emit(opcode, place, target.place, source.place);
    code_.emit(operand_word(target.offset), place);
    code_.emit(operand_word(source.offset), place);
    code_.emit(operand_word(count), place);
  };
  copy(Opcode::copy_memory, to.numbers, from.numbers, slots.numbers);
  copy(Opcode::copy_texts, to.texts, from.texts, slots.texts);
}

/// 0, FALSE, 0.0 have the same bits; texts become "".
void Variables::clear(const Location& home, const Type& type, Place place) {
  const Slots slots = slots_of(type);
  if (type.is(Type::Kind::List)) return;  // it is empty from its declaration on
  if (slots.numbers > 0 && home.numbers.in_register()) {
    for (int i = 0; i < slots.numbers; ++i) {
      code_.load_integer(home.numbers.behind(i).reg(), 0, place);
    }
  } else if (slots.numbers > 0) {
    code_.emit(Opcode::clear_memory, place, home.numbers.place);
    code_.emit(operand_word(home.numbers.offset), place);
    code_.emit(operand_word(slots.numbers), place);
  }
  if (slots.texts > 0 && home.texts.in_register()) {
    code_.load_text(home.texts.reg(), "", place);
  } else if (slots.texts > 0) {
    code_.emit(Opcode::clear_texts, place, home.texts.place);
    code_.emit(operand_word(home.texts.offset), place);
    code_.emit(operand_word(slots.texts), place);
  }
}

Register Variables::variable(const Symbol& variable, Place place) {
  const Register target = registers_for(variable.type);
  load_variable(variable, target, place);
  return target;
}

void Variables::store_variable(const Symbol& variable, Register value, Place place) {
  store(home(variable), variable.type, value, place);
  publish(variable, place);
}

void Variables::publish(const Symbol& symbol, Place place) {
  if (symbol.shared) publish(home(symbol), symbol.type, place);
}

void Variables::publish_part(const Symbol& root, const Location& at, const Type& type,
                             Place place) {
  if (!root.shared) return;
  if (root.type.is(Type::Kind::List)) return publish(root, place);
  publish(at, type, place);
}

void Variables::publish(const Location& at, const Type& type, Place place) {
  const Slots slots = slots_of(type);
  const auto mark = frame_.mark();
  const Register first = frame_.number_registers();
  if (type.is(Type::Kind::List)) {
    refer(at.numbers, false, first, place);
    code_.emit(Opcode::publish_list, place, first);
    return frame_.release(mark);
  }
  if (slots.numbers > 0) {
    refer(at.numbers, false, first, place);
    code_.publish(first, false, slots.numbers, place);
  }
  if (slots.texts > 0) {
    refer(at.texts, true, first, place);
    code_.publish(first, true, slots.texts, place);
  }
  frame_.release(mark);
}

/// They are known: at the beginning of the registers, or of the memory.
std::pair<std::size_t, std::size_t> Variables::places(const Symbol& global) const {
  const Location& at = homes_[global.id];
  const auto place = [](const SlotsAt& slots, std::size_t memory) {
    return (slots.base == SlotsAt::Base::Place ? memory : 0) + slots.offset;
  };
  return {place(at.numbers, kNumberStack), place(at.texts, kTextStack)};
}

/// Globals lie where they are known to lie: at the beginning of the registers, or of the memory.
void Variables::refresh(const std::vector<const Symbol*>& globals, bool latched, Place place) {
  for (const Symbol* const global : globals) {
    const Slots slots = slots_of(global->type);
    const Location& at = homes_[global->id];
    const bool in_memory = at.numbers.base == SlotsAt::Base::Place;
    code_.refresh((in_memory ? kNumberStack : 0) + at.numbers.offset, false, slots.numbers, latched,
                  place);
    code_.refresh((in_memory ? kTextStack : 0) + at.texts.offset, true, slots.texts, latched,
                  place);
  }
}

void Variables::begin_watch(const std::vector<const Expr*>& parts, Place place) {
  code_.begin_watch(place);
  watching_ = true;
  for (const Expr* const part : parts) {
    const Register first = frame_.number_registers(slots_of(part->type).numbers);
    const Location own{{Base::Own, first}, {}};
    if (const auto* const name = std::get_if<Name>(&part->node)) {
      homes_aside_.emplace_back(name->symbol, homes_[name->symbol->id]);
      settle(*name->symbol, own);
    } else {
      fixed_parts_.emplace_back(part, own);
    }
  }
}

void Variables::end_watch() {
  watching_ = false;
  fixed_parts_.clear();
  for (const auto& [symbol, home] : homes_aside_) settle(*symbol, home);
  homes_aside_.clear();
}

const Location* Variables::fixed_part(const Expr& expression) const {
  for (const auto& [part, location] : fixed_parts_) {
    if (part == &expression) return &location;
  }
  return nullptr;
}

}  // namespace rob::lang
