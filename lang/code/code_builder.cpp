#include "lang/code/code_builder.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "lang/code/watch.h"

namespace rob::lang {
namespace {

/// A word that is an operand of the instruction before it.
Instruction operand_word(std::size_t value) { return {static_cast<std::uint32_t>(value)}; }

}  // namespace

void CodeBuilder::emit(Instruction instruction, Place place) {
  if (frame_.beyond_registers()) limits_.exceed(Limit::Registers, place);
  chunk_.code.push_back(instruction);
  chunk_.places.push_back(place);
}

void CodeBuilder::load_constant(Register target, Slot value, std::uint64_t bits, Type type,
                                Place place) {
  const std::uint32_t index = tables_.constant(value, bits, type);
  if (index <= std::numeric_limits<std::uint16_t>::max()) {
    emit(Instruction::ax(Opcode::load_constant, target, index), place);
  } else {
    emit(Opcode::load_constant_wide, place, target);
    emit(operand_word(index), place);
  }
}

std::optional<std::uint8_t> CodeBuilder::constant_operand(Slot value, std::uint64_t bits,
                                                          Type type) {
  if (watch_) return std::nullopt;
  const std::uint32_t index = tables_.constant(value, bits, type);
  if (index > std::numeric_limits<std::uint8_t>::max()) return std::nullopt;
  return static_cast<std::uint8_t>(index);
}

void CodeBuilder::load_integer(Register target, std::int64_t value, Place place) {
  using Short = std::numeric_limits<std::int16_t>;
  if (value >= Short::min() && value <= Short::max()) {
    const auto bits = static_cast<std::uint16_t>(value);
    emit(Instruction::ax(Opcode::load_int, target, bits), place);
    return;
  }
  load_constant(target, Slot{.integer = value}, static_cast<std::uint64_t>(value), Type::integer(),
                place);
}

void CodeBuilder::load_real(Register target, double value, Dimension dimension, Place place) {
  load_constant(target, Slot{.real = value}, std::bit_cast<std::uint64_t>(value),
                Type::real(dimension), place);
}

void CodeBuilder::load_text(Register target, const std::string& text, Place place) {
  emit(Opcode::load_text, place, target);
  emit(operand_word(tables_.text(text)), place);
}

void CodeBuilder::with_text(Opcode op, unsigned a, unsigned b, const std::string& text,
                            Place place) {
  emit(op, place, a, b);
  emit(operand_word(tables_.text(text)), place);
}

void CodeBuilder::teach(Register pose, Register joints, int count, const std::string& point,
                        const std::string& frame, Place place) {
  if (!chunk_.first_teach) chunk_.first_teach = place;
  emit(Opcode::teach, place, pose, joints, static_cast<unsigned>(count));
  emit(operand_word(tables_.text(point)), place);
  emit(operand_word(tables_.text(frame)), place);
}

void CodeBuilder::append_real(Register text, Register value, Dimension dimension, Place place) {
  const std::size_t index = tables_.dimension(dimension);
  if (index > std::numeric_limits<std::uint8_t>::max()) limits_.exceed(Limit::Dimensions, place);
  emit(Opcode::append_real, place, text, value, static_cast<std::uint8_t>(index));
}

void CodeBuilder::append_value(Register text, Register first, const Type& type, Place place) {
  emit(Opcode::append_value, place, text, first);
  emit(operand_word(tables_.type(type)), place);
}

void CodeBuilder::append_memory(Opcode opcode, Register text, Register places, const Type& type,
                                Place place) {
  emit(opcode, place, text, places, static_cast<unsigned>(places + 1));
  emit(operand_word(tables_.type(type)), place);
}

void CodeBuilder::append_row(Register text, Register row, const Type& element, Place place) {
  emit(Opcode::append_row, place, text, row);
  emit(operand_word(tables_.type(element)), place);
}

void CodeBuilder::read_rows(Register file, Register places, const Type& type, Place place) {
  emit(Opcode::read_rows, place, file, places, static_cast<unsigned>(places + 1));
  emit(operand_word(tables_.type(type)), place);
}

void CodeBuilder::ask(Register text, Register answer, const Type& type, Place place) {
  emit(Opcode::ask, place, text, answer);
  emit(operand_word(tables_.type(type)), place);
}

void CodeBuilder::declare_persist(int number, PersistCode code) {
  const auto index = static_cast<std::size_t>(number);
  emit(Instruction::ax(Opcode::restore, 0, static_cast<std::uint16_t>(number)), code.place);
  chunk_.persists.resize(std::max(chunk_.persists.size(), index + 1));
  chunk_.persists[index] = std::move(code);
}

void CodeBuilder::declare_device(int number, DeviceCode code) {
  const auto index = static_cast<std::size_t>(number);
  chunk_.devices.resize(std::max(chunk_.devices.size(), index + 1));
  chunk_.devices[index] = std::move(code);
}

void CodeBuilder::receive(Register text, Register timeout, Register came, int device, Place place) {
  emit(Opcode::receive, place, text, timeout, came);
  emit({static_cast<std::uint32_t>(device)}, place);
}

void CodeBuilder::simulate_line(Register after, Register text, int device, Place place) {
  emit(Opcode::simulate_line, place, after, text);
  emit({static_cast<std::uint32_t>(device)}, place);
}

void CodeBuilder::task_entry(Place place) {
  chunk_.task_entry = static_cast<std::uint32_t>(chunk_.code.size());
  emit(Opcode::call_test, place);
  emit(Opcode::end, place);
}

void CodeBuilder::start(std::size_t task, Place place) {
  depends_on_time();
  emit(Opcode::start, place);
  emit(operand_word(task), place);
}

void CodeBuilder::publish(Register first, bool texts, int count, Place place) {
  if (count == 0) return;
  emit(Opcode::publish, place, first, texts ? 1 : 0);
  emit(operand_word(static_cast<std::size_t>(count)), place);
}

void CodeBuilder::refresh(std::size_t first, bool texts, int count, bool latched, Place place) {
  if (count == 0) return;
  emit(Opcode::refresh, place, texts ? 1 : 0, 0, latched ? 1 : 0);
  emit(operand_word(first), place);
  emit(operand_word(static_cast<std::size_t>(count)), place);
}

unsigned CodeBuilder::form_number(const MoveForm& form, Place place) {
  const std::size_t number = tables_.form(form);
  if (number > std::numeric_limits<std::uint16_t>::max()) limits_.exceed(Limit::Motions, place);
  return static_cast<std::uint16_t>(number);
}

void CodeBuilder::move(Register first, const MoveForm& form, Place place) {
  emit(Instruction::ax(Opcode::move, first, form_number(form, place)), place);
}

void CodeBuilder::via(Register first, const MoveForm& form, Place place) {
  emit(Instruction::ax(Opcode::via, first, form_number(form, place)), place);
}

void CodeBuilder::defaults(Opcode opcode, Register first, const MoveForm& form, Place place) {
  emit(Instruction::ax(opcode, first, form_number(form, place)), place);
}

void CodeBuilder::move_to(const MoveForm& form, std::span<const double> components, Place place) {
  emit(Instruction::ax(Opcode::move_to, 0, form_number(form, place)), place);
  for (const double component : components) {
    for (const Instruction half : words_of(component)) emit(half, place);
  }
}

void CodeBuilder::reserve(std::size_t statements, std::size_t words) {
  if (statements * words < here()) return;  // growing to twice its size does not cost more
  constexpr std::size_t kMore = 256;        // [choice] statements that may follow, END for one
  chunk_.code.reserve(here() + (statements + kMore) * words);
  chunk_.places.reserve(statements + kMore);
}

CodeBuilder::Jump CodeBuilder::jump(Place place) {
  emit(Instruction::jump(Opcode::jump, 0), place);
  return here() - 1;
}

void CodeBuilder::set_distance(std::size_t at, std::size_t target) {
  const auto distance = static_cast<std::int64_t>(target) - static_cast<std::int64_t>(at) - 1;
  const auto reach = static_cast<std::int64_t>(kFarthestJump);
  if (distance > reach || distance < -reach) {
    limits_.exceed(Limit::Jump, chunk_.places[at]);
    return;
  }
  chunk_.code[at] =
      Instruction::jump(chunk_.code[at].opcode(), static_cast<std::int32_t>(distance));
}

void CodeBuilder::land(const Jumps& jumps) {
  for (const Jump jump : jumps) set_distance(jump, here());
  last_element_.keep();
}

void CodeBuilder::loop(std::size_t target, Place place) {
  emit(Instruction::jump(Opcode::loop, 0), place);
  set_distance(here() - 1, target);
}

void CodeBuilder::join_turns(std::size_t body, Register value) {
  constexpr std::size_t kWords = 3;  // of a store_element
  if (here() != body + kWords) return;
  Instruction& store = chunk_.code[body];
  if (store.b() != value) return;
  const bool constant = store.opcode() == Opcode::store_element_constant;
  if (!constant && (store.opcode() != Opcode::store_element || store.a() == value)) return;
  const Opcode fill = constant ? Opcode::fill_element_constant : Opcode::fill_element;
  store = Instruction::abc(fill, store.a(), store.b(), store.c());
}

void CodeBuilder::open_memory(Place place) {
  frame_.open_memory();
  reserves_.push_back(here());
  emit(Opcode::reserve, place, frame_.memory_register());
  emit(operand_word(0), place);
  emit(operand_word(0), place);
}

void CodeBuilder::begin_routine(const std::string& name, const Place& place, bool handler) {
  close_frame();
  frame_.begin();
  reserves_.clear();
  chunk_.routines.push_back({.name = name,
                             .place = place,
                             .handler = handler,
                             .entry = static_cast<std::uint32_t>(here()),
                             .memory = {}});
}

void CodeBuilder::close_frame() {
  const Slots registers = frame_.most_registers();
  const Slots memory = frame_.most_memory();
  const bool top = chunk_.routines.empty();
  (top ? chunk_.registers : chunk_.routines.back().registers) = registers.numbers;
  (top ? chunk_.text_registers : chunk_.routines.back().text_registers) = registers.texts;
  (top ? chunk_.memory : chunk_.routines.back().memory) = memory;
  for (const std::size_t reserve : reserves_) {
    chunk_.code[reserve + 1] = operand_word(static_cast<std::size_t>(memory.numbers));
    chunk_.code[reserve + 2] = operand_word(static_cast<std::size_t>(memory.texts));
  }
}

void CodeBuilder::call_test(Place place) {
  const Room room = frame_.room();
  emit(Opcode::call_test, place, static_cast<unsigned>(room.numbers),
       static_cast<unsigned>(room.texts));
}

void CodeBuilder::call(std::size_t routine, Register numbers, Register texts, Place place) {
  emit(Opcode::call, place, numbers, texts);
  emit(operand_word(routine), place);
}

void CodeBuilder::begin_watch(Place place) {
  const Jump over = jump(place);
  watch_ = {.over = over, .entry = here()};
  frame_.put_aside();
}

std::uint16_t CodeBuilder::end_watch(Register answer, int values, Place place) {
  emit(Opcode::answer, place, answer);
  frame_.bring_back();
  const auto [over, entry] = *std::exchange(watch_, std::nullopt);
  land(over);
  for (std::size_t at = entry; at < here(); ++at) {
    const Opcode opcode = chunk_.code[at].opcode();
    if (!is_watchable(opcode)) limits_.exceed(Limit::Watch, chunk_.places[at]);
    const bool operand = opcode == Opcode::load_constant_wide || opcode == Opcode::equal_block;
    if (operand) ++at;
  }
  const std::size_t index = chunk_.watches.size();
  if (here() - entry > kLongestWatch || values > kMostWatched ||
      index > std::numeric_limits<std::uint16_t>::max()) {
    limits_.exceed(Limit::WatchLength, place);
  }
  chunk_.watches.push_back({.entry = static_cast<std::uint32_t>(entry),
                            .end = static_cast<std::uint32_t>(here()),
                            .values = static_cast<std::uint8_t>(values)});
  return static_cast<std::uint16_t>(index);
}

void CodeBuilder::when(Register values, std::uint16_t watch, std::size_t level, Place place) {
  emit(Instruction::ax(Opcode::when, values, watch), place);
  emit(operand_word(level), place);
}

void CodeBuilder::when_handle(Register first, int count, bool stops, std::size_t routine,
                              Place place) {
  depends_on_time();
  emit(Opcode::when_handle, place, first, static_cast<unsigned>(count), stops ? 1 : 0);
  emit(operand_word(routine), place);
}

void CodeBuilder::allow(std::vector<std::string> bodies, Place place) {
  emit(Instruction::ax(Opcode::allow, 0, static_cast<std::uint16_t>(chunk_.allowed.size())), place);
  if (chunk_.allowed.size() >= std::numeric_limits<std::uint16_t>::max())
    limits_.exceed(Limit::Motions, place);
  chunk_.allowed.push_back(std::move(bodies));
}

Chunk CodeBuilder::finish() {
  close_frame();
  tables_.move_into(chunk_);
  chunk_.names = frame_.take_names();
  return std::move(chunk_);
}

}  // namespace rob::lang
