#include "lang/vm/vm.h"

/// Member functions of Vm for TASKs.
namespace rob::lang {

Vm::Vm(const Chunk& chunk, Machine& machine, std::size_t task, TaskMemory& memory,
       std::uint64_t seed)
    : chunk_(&chunk),
      machine_(&machine),
      number_stack_(memory.numbers(task)),
      text_stack_(memory.texts(task)),
      registers_(memory.stack_begin(task) + kTaskRegisters),
      registers_end_(number_stack_.data() + registers_.numbers),
      text_registers_end_(text_stack_.data() + registers_.texts),
      background_(true),
      frames_(kMostCalls),
      frame_(frames_.data()),
      numbers_(number_stack_.data() + memory.stack_begin(task).numbers),
      texts_(text_stack_.data() + memory.stack_begin(task).texts),
      callees_(callees_of(chunk)),
      test_(chunk.tasks[task].routine),
      next_(chunk.code.data() + chunk.task_entry),
      latch_(next_),
      random_(seed),
      latched_random_(random_) {}

Reply Vm::publish(Code pc) {
  if (background_) return Reply::Done;  // its globals are those that all TASKs see
  const auto first = static_cast<std::size_t>(numbers_[pc->a()].integer);
  const std::uint32_t count = (pc + 1)->word;
  charge(count);
  if (pc->b() != 0) return machine_->publish(line(pc), first, text_stack_.subspan(first, count));
  return machine_->publish(line(pc), first, number_stack_.subspan(first, count));
}

Reply Vm::refresh(Code pc) {
  const std::size_t first = (pc + 1)->word;
  const std::uint32_t count = (pc + 2)->word;
  charge(count);
  const Reply reply = pc->a() != 0
                          ? machine_->refresh(line(pc), first, text_stack_.subspan(first, count))
                          : machine_->refresh(line(pc), first, number_stack_.subspan(first, count));
  if (reply == Reply::Done) {
    observed_ = true;
    turned_ = false;
  }
  return reply;
}

}  // namespace rob::lang
