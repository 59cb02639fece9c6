#include "lang/code/code_builder.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "lang/code/watch.h"

namespace rob::lang {
namespace {

/// A word that is an operand of the instruction before it.
Instruction operand_word(std::size_t value) { return {static_cast<std::uint32_t>(value)}; }

/// The index of `value` in `table`, where it is appended if it is new.
template <typename T>
std::size_t index_in(std::vector<T>& table, const T& value) {
  const auto found = std::ranges::find(table, value);
  if (found != table.end()) return static_cast<std::size_t>(found - table.begin());
  table.push_back(value);
  return table.size() - 1;
}

}  // namespace

Register CodeBuilder::Registers::take(int count) {
  const int first = used;
  used += count;
  most = std::max(most, used);
  return static_cast<Register>(std::min(first, kMostRegisters - 1));
}

void CodeBuilder::fail(Limit limit, Place place) {
  if (failed_ != Limit::None) return;
  failed_ = limit;
  failed_at_ = place;
}

void CodeBuilder::emit(Instruction instruction, Place place) {
  if (numbers_.used > kMostRegisters || texts_.used > kMostRegisters) {
    fail(Limit::Registers, place);
  }
  chunk_.code.push_back(instruction);
  chunk_.places.push_back(place);
}

std::uint32_t CodeBuilder::constant_index(Slot value, std::uint64_t bits, Type type) {
  const auto next = static_cast<std::uint32_t>(chunk_.constants.size());
  const auto [entry, added] =
      constant_indices_.try_emplace(std::tuple(bits, type.kind, type.dimension), next);
  if (added) {
    chunk_.constants.push_back(value);
    chunk_.constant_types.push_back(type);
  }
  return entry->second;
}

void CodeBuilder::load_constant(Register target, Slot value, std::uint64_t bits, Type type,
                                Place place) {
  const std::uint32_t index = constant_index(value, bits, type);
  if (index <= std::numeric_limits<std::uint16_t>::max()) {
    emit(Instruction::ax(Opcode::load_constant, target, index), place);
  } else {
    emit(Opcode::load_constant_wide, place, target);
    emit(operand_word(index), place);
  }
}

std::optional<std::uint8_t> CodeBuilder::constant_operand(Slot value, std::uint64_t bits,
                                                          Type type) {
  if (watching_) return std::nullopt;
  const std::uint32_t index = constant_index(value, bits, type);
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

std::size_t CodeBuilder::text_index(const std::string& text) {
  const auto [entry, added] =
      text_indices_.try_emplace(text, static_cast<std::uint32_t>(chunk_.texts.size()));
  if (added) chunk_.texts.push_back(text);
  return entry->second;
}

void CodeBuilder::load_text(Register target, const std::string& text, Place place) {
  emit(Opcode::load_text, place, target);
  emit(operand_word(text_index(text)), place);
}

void CodeBuilder::teach(Register pose, const std::string& point, const std::string& frame,
                        Place place) {
  if (!chunk_.first_teach) chunk_.first_teach = place;
  emit(Opcode::teach, place, pose);
  emit(operand_word(text_index(point)), place);
  emit(operand_word(text_index(frame)), place);
}

void CodeBuilder::fail_assertion(const std::string& condition, Place place) {
  emit(Opcode::fail_assertion, place);
  emit(operand_word(text_index(condition)), place);
}

void CodeBuilder::append_real(Register text, Register value, Dimension dimension, Place place) {
  const std::size_t index = index_in(chunk_.dimensions, dimension);
  if (index > std::numeric_limits<std::uint8_t>::max()) fail(Limit::Dimensions, place);
  emit(Opcode::append_real, place, text, value, static_cast<std::uint8_t>(index));
}

void CodeBuilder::append_value(Register text, Register first, const Type& type, Place place) {
  emit(Opcode::append_value, place, text, first);
  emit(operand_word(index_in(chunk_.types, type)), place);
}

void CodeBuilder::append_memory(Register text, Register places, const Type& type, Place place) {
  emit(Opcode::append_memory, place, text, places, static_cast<unsigned>(places + 1));
  emit(operand_word(index_in(chunk_.types, type)), place);
}

void CodeBuilder::ask(Register text, Register answer, const Type& type, Place place) {
  emit(Opcode::ask, place, text, answer);
  emit(operand_word(index_in(chunk_.types, type)), place);
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

std::uint16_t CodeBuilder::form_index(const MoveForm& form, Place place) {
  const std::size_t index = index_in(chunk_.moves, form);
  if (index > std::numeric_limits<std::uint16_t>::max()) fail(Limit::Motions, place);
  return static_cast<std::uint16_t>(index);
}

void CodeBuilder::move(Register first, const MoveForm& form, Place place) {
  emit(Instruction::ax(Opcode::move, first, form_index(form, place)), place);
}

void CodeBuilder::via(Register first, const MoveForm& form, Place place) {
  emit(Instruction::ax(Opcode::via, first, form_index(form, place)), place);
}

void CodeBuilder::move_to(const MoveForm& form, std::span<const double> components, Place place) {
  emit(Instruction::ax(Opcode::move_to, 0, form_index(form, place)), place);
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
    fail(Limit::Jump, chunk_.places[at]);
    return;
  }
  chunk_.code[at] =
      Instruction::jump(chunk_.code[at].opcode(), static_cast<std::int32_t>(distance));
}

void CodeBuilder::land(const Jumps& jumps) {
  for (const Jump jump : jumps) set_distance(jump, here());
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

void CodeBuilder::name_register(const std::string& name, Register index, bool text) {
  const auto now = static_cast<std::uint32_t>(here());
  live_names_.push_back(chunk_.names.size());
  chunk_.names.push_back({.name = name, .index = index, .text = text, .from = now, .to = now});
}

void CodeBuilder::open_memory(Place place) {
  memory_register_ = number_registers(2);
  reserves_.push_back(here());
  emit(Opcode::reserve, place, *memory_register_);
  emit(operand_word(0), place);
  emit(operand_word(0), place);
}

Slots CodeBuilder::take_memory(Slots slots, Place place) {
  const Slots first = memory_;
  // Each part is within kMemory, so this many of them cannot overflow before the code is given up.
  memory_ = memory_ + slots;
  if (memory_.numbers > kMemory.numbers || memory_.texts > kMemory.texts) {
    fail(Limit::Memory, place);
    memory_ = first;
  }
  most_memory_ = {std::max(most_memory_.numbers, memory_.numbers),
                  std::max(most_memory_.texts, memory_.texts)};
  return first;
}

void CodeBuilder::begin_behind(const Room& room) {
  numbers_.used = std::max(numbers_.used, room.numbers);
  texts_.used = std::max(texts_.used, room.texts);
  numbers_.most = std::max(numbers_.most, numbers_.used);
  texts_.most = std::max(texts_.most, texts_.used);
  take_memory({std::max(room.memory.numbers - memory_.numbers, 0),
               std::max(room.memory.texts - memory_.texts, 0)},
              {});
}

void CodeBuilder::release(const Mark& mark) {
  memory_ = mark.memory;
  numbers_.used = mark.numbers;
  texts_.used = mark.texts;
  while (live_names_.size() > mark.names) {
    chunk_.names[live_names_.back()].to = static_cast<std::uint32_t>(here());
    live_names_.pop_back();
  }
}

void CodeBuilder::begin_routine(const std::string& name, const Place& place, bool handler) {
  close_frame();
  numbers_ = {};
  texts_ = {};
  memory_ = most_memory_ = {};
  memory_register_.reset();
  reserves_.clear();
  chunk_.routines.push_back({.name = name,
                             .place = place,
                             .handler = handler,
                             .entry = static_cast<std::uint32_t>(here()),
                             .memory = {}});
}

void CodeBuilder::close_frame() {
  const bool top = chunk_.routines.empty();
  (top ? chunk_.registers : chunk_.routines.back().registers) = numbers_.most;
  (top ? chunk_.text_registers : chunk_.routines.back().text_registers) = texts_.most;
  (top ? chunk_.memory : chunk_.routines.back().memory) = most_memory_;
  for (const std::size_t reserve : reserves_) {
    chunk_.code[reserve + 1] = operand_word(static_cast<std::size_t>(most_memory_.numbers));
    chunk_.code[reserve + 2] = operand_word(static_cast<std::size_t>(most_memory_.texts));
  }
}

void CodeBuilder::call(std::size_t routine, Register numbers, Register texts, Place place) {
  emit(Opcode::call, place, numbers, texts);
  emit(operand_word(routine), place);
}

void CodeBuilder::begin_watch(Place place) {
  const Jump over = jump(place);
  watching_ = true;
  watch_ = {.numbers = numbers_, .texts = texts_, .over = over, .entry = here()};
  numbers_ = {};
  texts_ = {};
}

std::uint16_t CodeBuilder::end_watch(Register answer, int values, Place place) {
  emit(Opcode::answer, place, answer);
  watching_ = false;
  numbers_ = watch_.numbers;
  texts_ = watch_.texts;
  land(watch_.over);
  for (std::size_t at = watch_.entry; at < here(); ++at) {
    const Opcode opcode = chunk_.code[at].opcode();
    if (!is_watchable(opcode)) fail(Limit::Watch, chunk_.places[at]);
    const bool operand = opcode == Opcode::load_constant_wide || opcode == Opcode::equal_block;
    if (operand) ++at;
  }
  const std::size_t index = chunk_.watches.size();
  if (here() - watch_.entry > kLongestWatch || values > kMostWatched ||
      index > std::numeric_limits<std::uint16_t>::max()) {
    fail(Limit::WatchLength, place);
  }
  chunk_.watches.push_back({.entry = static_cast<std::uint32_t>(watch_.entry),
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

Chunk CodeBuilder::finish() {
  close_frame();
  return std::move(chunk_);
}

}  // namespace rob::lang
