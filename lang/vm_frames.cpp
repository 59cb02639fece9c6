#include <string>
#include <utility>

#include <fmt/core.h>

#include "lang/codes.h"
#include "lang/vm.h"

/// The part of Vm that knows frames, and what it says when something goes wrong.
namespace rob::lang {

Vm::Vm(const Chunk& chunk, Machine& machine, std::uint64_t seed)
    : chunk_(chunk),
      machine_(machine),
      number_stack_(chunk.routines.empty() ? kMostRegisters : kNumberStack),
      text_stack_(chunk.routines.empty() ? kMostRegisters : kTextStack),
      frames_(chunk.routines.empty() ? 0 : kMostCalls),
      numbers_(number_stack_.data()),
      texts_(text_stack_.data()),
      called_in_(chunk.routines.size()),
      next_(chunk.code.data()),
      latch_(next_),
      paid_(next_),
      random_(seed),
      latched_random_(random_) {}

Vm::State Vm::run(std::int64_t budget) {
  if (state_ == State::Done || state_ == State::Failed) return state_;
  budget_ = budget;
  do {
    if (rescuing_ && !rescue()) return state_ = leave(next_, next_, State::Waiting);
    state_ = execute(next_);
  } while (rescuing_);
  return state_;
}

Vm::State Vm::leave(Code pc, Code resume, State state) {
  executed_ += pc - paid_;
  paid_ = resume;
  next_ = resume;
  // An expression that starts anew draws the same random numbers.
  if (resume == latch_ && resume != pc) random_ = latched_random_;
  // When the program goes on, time has passed; only a used-up budget stays in the present cycle.
  if (state != State::Running) {
    observed_ = false;
    ++cycle_;
  }
  return state;
}

void Vm::pay(Code pc, Code target) {
  const auto spent = pc - paid_;
  executed_ += spent;
  budget_ -= spent;
  paid_ = target;
}

bool Vm::turn(Code pc, Code target) {
  pay(pc, target);
  turned_ = true;
  return budget_ > 0;
}

bool Vm::enter(Code pc) {
  const std::uint32_t number = (pc + 1)->word;
  const RoutineCode& routine = chunk_.routines[number];
  Slot* const numbers = numbers_ + pc->a();
  std::string* const texts = texts_ + pc->b();
  const auto left = number_stack_.data() + number_stack_.size() - numbers;
  const auto texts_left = text_stack_.data() + text_stack_.size() - texts;
  if (depth_ == frames_.size() || left < routine.registers || texts_left < routine.text_registers) {
    return false;
  }
  frames_[depth_++] = {pc + 2, numbers_, texts_, number};
  numbers_ = numbers;
  texts_ = texts;
  if (called_in_[number] == cycle_) turned_ = true;
  called_in_[number] = cycle_;
  return true;
}

Vm::Code Vm::leave_routine() {
  const Frame& frame = frames_[--depth_];
  numbers_ = frame.numbers;
  texts_ = frame.texts;
  return frame.back;
}

Vm::State Vm::fail(Code pc, RuntimeError error) {
  error_ = std::move(error);
  for (std::size_t i = depth_; i > 0; --i) {
    const Frame& frame = frames_[i - 1];
    error_.calls.push_back(
        {.routine = chunk_.routines[frame.routine].name, .line = line(frame.back - 1)});
  }
  return give_up(pc);
}

Vm::State Vm::fail(Code pc, ArithmeticError error) {
  const ArithmeticErrorText text = describe(error);
  return fail(pc, {.code = std::string(text.code),
                   .place = place(pc),
                   .message = std::string(text.message),
                   .help = std::string(text.help)});
}

Vm::State Vm::fail_too_long(Code pc) {
  return fail(pc, {.code = std::string(code::kTextTooLong),
                   .place = place(pc),
                   .message = fmt::format("a text of more than {} bytes", kMostText),
                   .help = ""});
}

Vm::State Vm::fail_calls_too_deep(Code pc) {
  return fail(pc, {.code = std::string(code::kCallsTooDeep),
                   .place = place(pc),
                   .message = fmt::format("the calls are nested too deep: at most {}", kMostCalls),
                   .help = "a routine that calls itself needs a way that does not"});
}

Vm::State Vm::fail_no_value(Code pc) {
  return fail(pc, {.code = std::string(code::kEndedWithoutReturn),
                   .place = place(pc),
                   .message = fmt::format("{} came to its end without RETURN",
                                          chunk_.routines[frames_[depth_ - 1].routine].name),
                   .help = "RETURN a value on every way through it"});
}

Vm::State Vm::fail_index(Code pc, std::int64_t index, std::uint32_t count) {
  return fail(
      pc, {.code = std::string(code::kIndexOutOfRange),
           .place = place(pc),
           .message = fmt::format("there is no element {}: they count from 1 to {}", index, count),
           .help = ""});
}

Vm::State Vm::fail_assertion_at(Code pc) {
  return fail(pc, {.code = std::string(code::kAssertionFailed),
                   .place = place(pc),
                   .message = fmt::format("ASSERT {} does not hold", chunk_.texts[(pc + 1)->word]),
                   .help = ""});
}

}  // namespace rob::lang
