#include <algorithm>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "lang/text/codes.h"
#include "lang/values/value_text.h"
#include "lang/vm/texts.h"
#include "lang/vm/vm.h"

/// Member functions of Vm for frames, and for the messages when something goes wrong.
namespace rob::lang {
namespace {

Slots registers_of(const Chunk& chunk) {
  if (chunk.routines.empty()) return {kMostRegisters, kMostRegisters};
  return {static_cast<int>(kNumberStack), static_cast<int>(kTextStack)};
}

/// More than a program executes in a year; in bytes of code it still fits 64 bits.
constexpr std::int64_t kMostBudget = std::int64_t{1} << 56;

/// Without memory in routines, what the top level takes is all.
Slots memory_of(const Chunk& chunk) { return takes_memory(chunk) ? kMemory : chunk.memory; }

}  // namespace

Vm::Vm(const Chunk& chunk, Machine& machine, std::uint64_t seed)
    : chunk_(&chunk),
      machine_(&machine),
      own_numbers_(static_cast<std::size_t>((registers_of(chunk) + memory_of(chunk)).numbers)),
      own_texts_(static_cast<std::size_t>((registers_of(chunk) + memory_of(chunk)).texts)),
      number_stack_(own_numbers_),
      text_stack_(own_texts_),
      registers_(registers_of(chunk)),
      registers_end_(number_stack_.data() + registers_.numbers),
      text_registers_end_(text_stack_.data() + registers_.texts),
      frames_(chunk.routines.empty() ? 0 : kMostCalls),
      frame_(frames_.data()),
      numbers_(number_stack_.data()),
      texts_(text_stack_.data()),
      callees_(callees_of(chunk)),
      next_(chunk.code.data()),
      latch_(next_),
      random_(seed),
      latched_random_(random_) {}

std::vector<Vm::Callee> Vm::callees_of(const Chunk& chunk) {
  std::vector<Callee> callees;
  callees.reserve(chunk.routines.size());
  for (const RoutineCode& routine : chunk.routines) {
    callees.push_back({.entry = chunk.code.data() + routine.entry,
                       .registers = routine.registers,
                       .text_registers = routine.text_registers});
  }
  return callees;
}

bool Vm::reserve(Code pc) {
  const Slots place = registers_ + memory_;
  const Slots end =
      place + Slots{static_cast<int>((pc + 1)->word), static_cast<int>((pc + 2)->word)};
  if (end.numbers > static_cast<int>(number_stack_.size()) ||
      end.texts > static_cast<int>(text_stack_.size())) {
    return false;
  }
  numbers_[pc->a()].integer = place.numbers;
  numbers_[pc->a() + 1].integer = place.texts;
  memory_ = {end.numbers - registers_.numbers, end.texts - registers_.texts};
  return true;
}

bool Vm::append_memory(Code pc) {
  std::string& text = texts_[pc->a()];
  const std::size_t before = text.size();
  const Type& type = chunk_->types[(pc + 1)->word];
  const Slots slots = slots_of(type);
  const bool fits =
      append_value_text(text, type, slots.numbers > 0 ? place_of(numbers_[pc->b()], 0) : nullptr,
                        slots.texts > 0 ? text_place_of(numbers_[pc->c()], 0) : nullptr, kMostText);
  charge(static_cast<std::uint32_t>(text.size() - before));
  return fits;
}

Vm::State Vm::run(std::int64_t budget) {
  if (state_ == State::Done || state_ == State::Failed || circling_ != 0) return state_;
  granted_ = std::min(budget, kMostBudget);
  for (;;) {
    if (rescuing_ && !rescue()) return state_ = leave(next_, next_, State::Waiting);
    limit_ = address(next_) + granted_ * kWord;
    const bool handling = handling_;
    state_ = execute(next_);
    const bool handled = handling && !handling_ && state_ == State::Running;
    if (!rescuing_ && !handled) return state_;
  }
}

Vm::State Vm::leave(Code pc, Code resume, State state) {
  const std::int64_t left = left_at(pc);
  executed_ += granted_ - left;
  granted_ = left;
  next_ = resume;
  // An expression that starts anew draws the same random numbers.
  if (resume == latch_ && resume != pc) random_ = latched_random_;
  // When the program goes on, time has passed; only a used-up budget stays in the current cycle.
  if (state != State::Running) {
    observed_ = false;
    ++cycle_;
    // What still runs counts as called in the cycle in which it goes on.
    std::for_each(frames_.data(), frame_,
                  [&](const Frame& frame) { callee_of(frame).called_in = cycle_; });
  }
  return state;
}

void Vm::limit_turns(std::uint32_t most) { most_turns_ = most; }

/// The loops inside this one begin anew with each of its turns.
bool Vm::count_turn(Code pc, Code target) {
  const Opcode before = (pc - 2)->opcode();  // `pc` is behind the jump
  if (before == Opcode::for_next_int || before == Opcode::for_next_real) return true;
  turns_.erase(turns_.upper_bound(index(target)), turns_.lower_bound(index(pc)));
  Turns& turns = turns_[index(target)];
  if (turns.motions != motions_) turns = {0, motions_};
  if (++turns.count < most_turns_) return true;
  circling_ = line(target);
  return false;
}

void Vm::choose_test(std::size_t test) {
  test_ = chunk_->tests.at(test).routine;
  next_ = chunk_->code.data() + chunk_->test_entry;
  latch_ = next_;
}

Vm::State Vm::fail(Code pc, RuntimeError error) {
  error_ = std::move(error);
  for (const Frame* frame = frame_; frame != frames_.data();) {
    --frame;
    const Chunk& chunk = chunk_of(*frame);
    const RoutineCode& routine = chunk.routines[frame->routine];
    if (routine.handler) {
      error_.calls.push_back({routine.name, line_tag(routine.place), CallSite::By::When});
    } else {
      error_.calls.push_back(
          {.routine = routine.name, .line = line_tag(place(chunk, frame->back - 1))});
    }
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

Vm::State Vm::fail_memory(Code pc) {
  return fail(pc,
              {.code = std::string(code::kCallsTooDeep),
               .place = place(pc),
               .message = fmt::format("the calls need more memory for arrays and records than "
                                      "there is: {} numbers and {} texts",
                                      static_cast<int>(number_stack_.size()) - registers_.numbers,
                                      static_cast<int>(text_stack_.size()) - registers_.texts),
               .help = "REF passes an array without copying it"});
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
                   .message = fmt::format("ASSERT {} does not hold", chunk_->texts[(pc + 1)->word]),
                   .help = ""});
}

}  // namespace rob::lang
