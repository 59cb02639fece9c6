#include "lang/vm/vm.h"

/// Member functions of Vm that execute entries of the prompt, one after another.
namespace rob::lang {

Vm::Vm(Machine& machine, std::uint64_t seed)
    : chunk_(&nothing()),
      machine_(&machine),
      entries_(true),
      own_numbers_(kNumberStack + static_cast<std::size_t>(kMemory.numbers)),
      own_texts_(kTextStack + static_cast<std::size_t>(kMemory.texts)),
      number_stack_(own_numbers_),
      text_stack_(own_texts_),
      registers_{static_cast<int>(kNumberStack), static_cast<int>(kTextStack)},
      registers_end_(number_stack_.data() + registers_.numbers),
      text_registers_end_(text_stack_.data() + registers_.texts),
      frames_(kMostCalls),
      frame_(frames_.data()),
      numbers_(number_stack_.data()),
      texts_(text_stack_.data()),
      state_(State::Done),
      next_(chunk_->code.data()),
      latch_(next_),
      random_(seed),
      latched_random_(random_) {}

/// What there is before the first entry.
const Chunk& Vm::nothing() {
  static const Chunk chunk = [] {
    Chunk empty;
    empty.code.push_back(Instruction::abc(Opcode::end));
    empty.places.push_back({});
    return empty;
  }();
  return chunk;
}

void Vm::go_on_with(const Chunk& chunk) {
  chunk_ = &chunk;
  callees_ = callees_of(chunk);
  next_ = latch_ = chunk.code.data();
  memory_ = {};
  turned_ = false;
  state_ = State::Running;
}

Reply Vm::give_up_entry() {
  const int at = state_ == State::Failed ? line_tag(error_.place) : line(next_);
  if (handling_) abandon_handler();
  if (const Reply reply = end_presses(at, 0); reply != Reply::Done) return reply;
  leave_settings(at, 0);
  if (const Reply reply = disarm(at, kept_whens_); reply != Reply::Done) return reply;
  guards_.clear();
  frame_ = frames_.data();
  numbers_ = number_stack_.data();
  texts_ = text_stack_.data();
  state_ = State::Done;
  return Reply::Done;
}

void Vm::forget_whens() { armed_count_ = kept_whens_ = 0; }

}  // namespace rob::lang
