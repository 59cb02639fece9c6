#include <string>
#include <utility>

#include <fmt/core.h>

#include "lang/codes.h"
#include "lang/vm.h"

/// The part of Vm that knows frames, and what it says when something goes wrong.
namespace rob::lang {

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

Vm::State Vm::fail_assertion_at(Code pc) {
  return fail(pc, {.code = std::string(code::kAssertionFailed),
                   .place = place(pc),
                   .message = fmt::format("ASSERT {} does not hold", chunk_.texts[(pc + 1)->word]),
                   .help = ""});
}

}  // namespace rob::lang
