#include "lang/vm/stack.h"

#include <algorithm>
#include <functional>

#include <fmt/core.h>

#include "lang/text/codes.h"

namespace rob::lang {
namespace {

constexpr Slots kAllRegisters{static_cast<int>(kNumberStack), static_cast<int>(kTextStack)};

/// Without routines one frame is all, but for PERSIST variables, whose places in memory count from
/// the end of all registers.
Slots registers_of(const Chunk& chunk) {
  const bool one_frame = chunk.routines.empty() && chunk.persists.empty();
  return one_frame ? Slots{kMostRegisters, kMostRegisters} : kAllRegisters;
}

/// Without memory in routines, what the top level takes is all.
Slots memory_of(const Chunk& chunk) { return takes_memory(chunk) ? kMemory : chunk.memory; }

std::size_t size(int slots) { return static_cast<std::size_t>(slots); }

}  // namespace

std::vector<Callee> callees_of(const Chunk& chunk) {
  std::vector<Callee> callees;
  callees.reserve(chunk.routines.size());
  for (const RoutineCode& routine : chunk.routines) {
    callees.push_back({.entry = chunk.code.data() + routine.entry,
                       .registers = routine.registers,
                       .text_registers = routine.text_registers,
                       .routine = &routine,
                       .chunk = &chunk});
  }
  return callees;
}

Stack::Stack(const Chunk& chunk)
    : Stack(registers_of(chunk), memory_of(chunk), chunk.routines.empty() ? 0 : kMostCalls) {}

Stack::Stack() : Stack(kAllRegisters, kMemory, kMostCalls) {}

Stack::Stack(Slots registers, Slots memory, std::size_t calls)
    : own_numbers_(size((registers + memory).numbers)),
      own_texts_(size((registers + memory).texts)),
      number_stack_(own_numbers_),
      text_stack_(own_texts_),
      registers_(registers),
      registers_end_(number_stack_.data() + registers_.numbers),
      text_registers_end_(text_stack_.data() + registers_.texts),
      frames_(calls),
      frame_(frames_.data()),
      numbers_(number_stack_.data()),
      texts_(text_stack_.data()) {}

Stack::Stack(TaskStack stack)
    : number_stack_(stack.memory.numbers(stack.number)),
      text_stack_(stack.memory.texts(stack.number)),
      registers_(stack.memory.stack_begin(stack.number) + kTaskRegisters),
      registers_end_(number_stack_.data() + registers_.numbers),
      text_registers_end_(text_stack_.data() + registers_.texts),
      frames_(kMostCalls),
      frame_(frames_.data()),
      numbers_(number_stack_.data() + stack.memory.stack_begin(stack.number).numbers),
      texts_(text_stack_.data() + stack.memory.stack_begin(stack.number).texts),
      lists_(&stack.memory.lists()) {}

void Stack::unwind(std::size_t depth) {
  while (this->depth() > depth) leave();
  lists_->release_from(depth);
}

Slots Stack::room() const {
  return {static_cast<int>(number_stack_.size()) - registers_.numbers,
          static_cast<int>(text_stack_.size()) - registers_.texts};
}

bool Stack::reserve(Slots slots, Slot* place) {
  // Lists of frames as deep are of calls that have been left. Those of the top level stay.
  lists_->drop(std::max<std::size_t>(depth(), 1));
  const Slots end = memory_ + slots;
  if (end.numbers > room().numbers || end.texts > room().texts) return false;
  place[0].integer = registers_.numbers + memory_.numbers;
  place[1].integer = registers_.texts + memory_.texts;
  memory_ = end;
  return true;
}

void Stack::open_list(Slot home, Slots size) {
  place(home, 0)->integer = lists_->open(home.integer, depth(), size);
}

void Stack::locate_list(Slot home, Slot* row) {
  const ListElements& list = list_at(home);  // `home` may be of the row itself
  row[0].integer = list.numbers.empty() ? 0 : reference_to(list.numbers.data());
  row[1].integer = list.texts.empty() ? 0 : reference_to(list.texts.data());
  row[2].integer = static_cast<std::int64_t>(list.count);
}

Objection Stack::weigh(const std::string* at, std::size_t before, std::size_t now) {
  const std::less<> less;
  const std::string* const begin = text_stack_.data();
  const bool own = !less(at, begin) && less(at, begin + text_stack_.size());
  return own ? Objection{} : lists_->weigh(before, now);
}

Refusal calls_too_deep() {
  return {.code = std::string(code::kCallsTooDeep),
          .message = fmt::format("the calls are nested too deep: at most {}", kMostCalls),
          .help = "a routine that calls itself needs a way that does not"};
}

Refusal memory_used_up(Slots room) {
  return {.code = std::string(code::kCallsTooDeep),
          .message = fmt::format("the calls need more memory for arrays and records than there is: "
                                 "{} numbers and {} texts",
                                 room.numbers, room.texts),
          .help = "REF passes an array without copying it"};
}

}  // namespace rob::lang
