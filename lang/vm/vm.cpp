#include "lang/vm/vm.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>
#include <utility>

#include <fmt/core.h>

#include "lang/text/codes.h"
#include "lang/values/builtins.h"
#include "lang/values/number_text.h"
#include "lang/values/pose_functions.h"
#include "lang/values/value_text.h"

namespace rob::lang {

namespace {

constexpr double kSameTime = 1e-9;  // s: sums of cycles that differ by less are one

bool equal_slots(const Slot* a, const Slot* b, std::size_t count) {
  return std::memcmp(a, b, count * sizeof(Slot)) == 0;
}

void copy_texts(std::string* to, const std::string* from, std::size_t count) {
  if (to < from) {
    std::copy(from, from + count, to);
  } else if (to > from) {
    std::copy_backward(from, from + count, to + count);
  }
}

}  // namespace

// Computed goto, an extension that g++ and clang share: a jump of its own behind each instruction
// lets the processor predict the next one by the present one.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"

#define ROB_NEXT(words)                                    \
  do {                                                     \
    pc += (words);                                         \
    goto* kLabels[static_cast<std::size_t>(pc->opcode())]; \
  } while (false)
#define ROB_CHECKED(operation)                                  \
  do {                                                          \
    const ArithmeticError error = (operation);                  \
    if (error != ArithmeticError::None) return fail(pc, error); \
  } while (false)
#define ROB_ARITHMETIC(name, function, in, out)                                    \
  name:                                                                            \
  ROB_CHECKED(arithmetic::function(n[pc->b()].in, n[pc->c()].in, n[pc->a()].out)); \
  ROB_NEXT(1);
#define ROB_IF(name, condition, expected)                                   \
  name:                                                                     \
  if ((condition) == ((expected) != 0)) ROB_NEXT(2 + (pc + 1)->distance()); \
  ROB_NEXT(2)
#define ROB_TURN(target)                                            \
  do {                                                              \
    const Code top = (target);                                      \
    if (!turn(pc + 1, top)) return leave(top, top, State::Running); \
    pc = top;                                                       \
    ROB_NEXT(0);                                                    \
  } while (false)
// Into a routine or out of it. A recursion pays like a loop.
#define ROB_GO(words, target)                                   \
  do {                                                          \
    const Code next = (target);                                 \
    pay(pc + (words), next);                                    \
    if (budget_ <= 0) return leave(next, next, State::Running); \
    n = numbers_;                                               \
    pc = next;                                                  \
    ROB_NEXT(0);                                                \
  } while (false)
#define ROB_ASK(call, resume)                                  \
  do {                                                         \
    const Reply reply = (call);                                \
    if (reply != Reply::Done) return pause(pc, resume, reply); \
  } while (false)

Vm::State Vm::execute(Code pc) {
  static constexpr const void* kLabels[] = {
#define ROB_OPCODE(name, operands) &&name,
#include "lang/code/opcodes.def"
  };
  Slot* n = numbers_;
  const Slot* const constants = chunk_.constants.data();
  ROB_NEXT(0);

load_constant:
  n[pc->a()] = constants[pc->x()];
  ROB_NEXT(1);
load_constant_wide:
  n[pc->a()] = constants[(pc + 1)->word];
  ROB_NEXT(2);
load_int:
  n[pc->a()].integer = pc->signed_x();
  ROB_NEXT(1);
copy:
  n[pc->a()] = n[pc->b()];
  ROB_NEXT(1);
copy_block:
  std::memmove(&n[pc->a()], &n[pc->b()], pc->c() * sizeof(Slot));
  ROB_NEXT(1);
int_to_real:
  n[pc->a()].real = static_cast<double>(n[pc->b()].integer);
  ROB_NEXT(1);

#include "lang/code/arithmetic_opcodes.def"
#include "lang/vm/vm_constants.inc"
neg_int:
  ROB_CHECKED(arithmetic::negate(n[pc->b()].integer, n[pc->a()].integer));
  ROB_NEXT(1);
neg_real:
  ROB_CHECKED(arithmetic::negate(n[pc->b()].real, n[pc->a()].real));
  ROB_NEXT(1);
call_int:
  ROB_CHECKED(builtins()[pc->b()].integer({&n[pc->a()], pc->c()}, n[pc->a()]));
  ROB_NEXT(1);
call_real:
  ROB_CHECKED(builtins()[pc->b()].real({&n[pc->a()], pc->c()}, n[pc->a()]));
  ROB_NEXT(1);
call_text:
  ROB_CHECKED(builtins()[pc->c()].text(&n[pc->a()], &texts_[pc->b()]));
  ROB_NEXT(1);
pose_product:
  ROB_CHECKED(pose_functions::product(&n[pc->b()], &n[pc->c()], &n[pc->a()]));
  ROB_NEXT(1);
pose_transform:
  ROB_CHECKED(pose_functions::transformed(&n[pc->b()], &n[pc->c()], &n[pc->a()]));
  ROB_NEXT(1);
pose_angle:
  pose_functions::angle(&n[pc->b()], pc->c(), n[pc->a()]);
  ROB_NEXT(1);
forward:
  ROB_ASK(forward(pc), pc);
  ROB_NEXT(1);
inverse:
  ROB_ASK(inverse(pc), pc);
  ROB_NEXT(2);
random:
  n[pc->a()].real = random_.share();
  ROB_NEXT(1);
random_int : {
  Slot* const range = &n[pc->a()];
  ROB_CHECKED(random_.between(range[0].integer, range[1].integer, range[0].integer));
  ROB_NEXT(1);
}
random_real : {
  Slot* const range = &n[pc->a()];
  ROB_CHECKED(random_.between(range[0].real, range[1].real, range[0].real));
  ROB_NEXT(1);
}

#include "lang/vm/vm_memory.inc"
#include "lang/vm/vm_places.inc"

call : {
  if (!enter(pc)) return fail_calls_too_deep(pc);
  const Code target = chunk_.code.data() + chunk_.routines[(pc + 1)->word].entry;
  ROB_GO(2, target);
}
leave:
  ROB_GO(1, leave_routine());
leave_with:
  std::memmove(numbers_, &n[pc->a()], pc->b() * sizeof(Slot));
  ROB_GO(1, leave_routine());
leave_with_text:
  if (pc->a() != 0) texts_[0] = texts_[pc->a()];
  ROB_GO(1, leave_routine());
no_value:
  return fail_no_value(pc);

equal_text:
  n[pc->a()].integer = texts_[pc->b()] == texts_[pc->c()] ? 1 : 0;
  ROB_NEXT(1);
less_text:  // UTF-8 sorts by bytes as by code points
  n[pc->a()].integer = texts_[pc->b()] < texts_[pc->c()] ? 1 : 0;
  ROB_NEXT(1);
less_equal_text:
  n[pc->a()].integer = texts_[pc->b()] <= texts_[pc->c()] ? 1 : 0;
  ROB_NEXT(1);

jump:
  ROB_NEXT(1 + pc->distance());
loop:
  ROB_TURN(pc + 1 + pc->distance());
  ROB_IF(if_bool, n[pc->a()].integer != 0, pc->b());
  ROB_IF(if_equal_int, n[pc->a()].integer == n[pc->b()].integer, pc->c());
  ROB_IF(if_less_int, n[pc->a()].integer < n[pc->b()].integer, pc->c());
  ROB_IF(if_less_equal_int, n[pc->a()].integer <= n[pc->b()].integer, pc->c());
  ROB_IF(if_equal_real, n[pc->a()].real == n[pc->b()].real, pc->c());
  ROB_IF(if_less_real, n[pc->a()].real < n[pc->b()].real, pc->c());
  ROB_IF(if_less_equal_real, n[pc->a()].real <= n[pc->b()].real, pc->c());

#include "lang/vm/vm_for.inc"

load_text:
  texts_[pc->a()] = chunk_.texts[(pc + 1)->word];
  ROB_NEXT(2);
copy_text:
  texts_[pc->a()] = texts_[pc->b()];
  ROB_NEXT(1);
join_text:
  if (!join(pc->a(), pc->b(), pc->c())) return fail_too_long(pc);
  ROB_NEXT(1);
append_int:
  if (!append(pc->a(), std::to_string(n[pc->b()].integer))) return fail_too_long(pc);
  ROB_NEXT(1);
append_real:
  if (!append(pc->a(), number_text(n[pc->b()].real, chunk_.dimensions[pc->c()]))) {
    return fail_too_long(pc);
  }
  ROB_NEXT(1);
append_bool:
  if (!append(pc->a(), text_of(n[pc->b()].integer != 0))) return fail_too_long(pc);
  ROB_NEXT(1);
append_value:
  if (!append_value_text(texts_[pc->a()], chunk_.types[(pc + 1)->word], &n[pc->b()], nullptr,
                         kMostText)) {
    return fail_too_long(pc);
  }
  ROB_NEXT(2);
append_text:
  if (!append(pc->a(), texts_[pc->b()])) return fail_too_long(pc);
  ROB_NEXT(1);

latch:
  latch_ = pc;
  latched_random_ = random_;
  ROB_NEXT(1);
read_signal:
  if (next_cycle_is_due()) return leave(pc, pc, State::NextCycle);
  ROB_ASK(observe(pc), pc);
  ROB_NEXT(1);
read_latched:
  if (next_cycle_is_due()) return leave(pc, latch_, State::NextCycle);
  ROB_ASK(observe(pc), latch_);
  ROB_NEXT(1);
read_analog:
  if (next_cycle_is_due()) return leave(pc, pc, State::NextCycle);
  ROB_ASK(observe_analog(pc), pc);
  ROB_NEXT(1);
read_analog_latched:
  if (next_cycle_is_due()) return leave(pc, latch_, State::NextCycle);
  ROB_ASK(observe_analog(pc), latch_);
  ROB_NEXT(1);
read : {
  if (!check_hit_pose(pc)) return fail(pc, std::move(error_));
  const Code resume = pc->c() != 0 ? latch_ : pc;
  if (waits_for_cycle(pc)) return leave(pc, resume, State::NextCycle);
  ROB_ASK(read(pc), resume);
  ROB_NEXT(1);
}
write_signal:
  ROB_ASK(machine_->write_signal(line(pc), pc->x(), n[pc->a()].integer != 0), pc);
  ROB_NEXT(1);
write_analog:
  ROB_ASK(machine_->write_analog(line(pc), pc->x(), n[pc->a()].real), pc);
  ROB_NEXT(1);
pulse:
  if (!check_pulse(pc, n[pc->a()].real)) return fail(pc, std::move(error_));
  ROB_ASK(machine_->pulse(line(pc), pc->x(), n[pc->a()].real), pc);
  ROB_NEXT(1);
move : {
  MoveCommand command;
  if (!build(pc, command)) return fail(pc, std::move(error_));
  ROB_ASK(machine_->move(line(pc), command), pc);
  ROB_NEXT(1);
}
move_to : {
  const MoveCommand command = build_plain(pc);
  ROB_ASK(machine_->move(line(pc), command), pc);
  ROB_NEXT(1 + 2 * std::popcount(command.given));
}
live_pace:
  ROB_ASK(live_pace(pc), pc);
  ROB_NEXT(2);
#include "lang/vm/vm_surroundings.inc"
guard:
  ROB_ASK(guard(pc), pc);
  ROB_NEXT(1);
ended:
  ROB_ASK(ended(pc), pc);
  ROB_NEXT(1);
when:
  if (armed_count_ == kMostWhens) return fail_too_many_whens(pc);
  ROB_ASK(when(pc), pc);
  ROB_NEXT(2);
when_raise:
  ROB_ASK(machine_->when_raise(line(pc), texts_[pc->a()]), pc);
  ROB_NEXT(1);
when_handle:
  ROB_ASK(when_handle(pc), pc);
  ROB_NEXT(2);
leave_handler:
  ROB_ASK(machine_->leave_handler(line(pc)), pc);
  leave(pc + 1, pc, State::Running);
  end_handler();
  return State::Running;
on_the_way:
  if (!check_place(pc)) return fail(pc, std::move(error_));
  ROB_ASK(machine_->on_the_way(line(pc), place_of(pc)), pc);
  ROB_NEXT(1);
disarm:
  ROB_ASK(disarm(line(pc), whens_below(pc->x())), pc);
  ROB_NEXT(1);
read_hit:
  n[pc->a()].integer = hit_ ? 1 : 0;
  ROB_NEXT(1);
answer:  // stands in code that is jumped over
  ROB_NEXT(1);
stop:
  ROB_ASK(machine_->stop(line(pc)), pc);
  ROB_NEXT(1);
zero_force:
  ROB_ASK(machine_->zero_force(line(pc)), pc);
  ROB_NEXT(1);
brake:
  ROB_ASK(machine_->brake(line(pc)), pc);
  ROB_NEXT(1);
teach:
  ROB_ASK(teach(pc), pc);
  ROB_NEXT(3);
halt:
  ROB_ASK(machine_->halt(line(pc), texts_[pc->a()]), pc);
  ROB_NEXT(1);
ask:
  ROB_ASK(ask(pc), pc);
  ROB_NEXT(2);
wait:
  if (!check_wait(pc, n[pc->a()].real)) return fail(pc, std::move(error_));
  ROB_ASK(machine_->wait(line(pc), n[pc->a()].real), pc);
  ROB_NEXT(1);
stand:
  if (next_cycle_is_due()) return leave(pc, pc, State::NextCycle);
  ROB_ASK(stand(pc), pc);
  ROB_NEXT(1);
  ROB_IF(if_elapsed, n[pc->a()].real - n[pc->b()].real >= n[pc->c()].real - kSameTime, 1);
  ROB_IF(if_assumed, machine_->taken_as_met(line(pc)), 1);
waited:
  ROB_ASK(machine_->waited(line(pc)), pc);
  ROB_NEXT(1);
fail_timeout:
  return fail_timeout(pc);
print:
  ROB_ASK(machine_->print(line(pc), texts_[pc->a()]), pc);
  ROB_NEXT(1);
fail_assertion:
  return fail_assertion_at(pc);
call_test : {
  if (!enter_test(pc)) return fail_calls_too_deep(pc);
  const Code target = chunk_.code.data() + chunk_.routines[test_].entry;
  ROB_GO(1, target);
}
expect_failed:
  ROB_ASK(machine_->expectation_failed(line(pc), texts_[pc->a()]), pc);
  ROB_NEXT(1);
#include "lang/vm/vm_simulate.inc"
#include "lang/vm/vm_tasks.inc"
open_try:
  if (!open_try(pc)) return fail_tries_too_deep(pc);
  ROB_NEXT(2);
leave_try:
  ROB_ASK(machine_->leave_block(line(pc)), pc);
  guards_.pop_back();
  ROB_NEXT(1);
leave_rescue:
  guards_.pop_back();
  ROB_NEXT(1);
raise:
  return fail(pc, {.code = std::string(code::kRaised),
                   .place = place(pc),
                   .message = texts_[pc->a()],
                   .help = texts_[pc->a()].empty() ? "the text behind this RAISE is empty" : ""});
raise_again:
  return raise_again(pc);
end:
  ROB_ASK(machine_->end(line(pc)), pc);
  return leave(pc + 1, pc, State::Done);
}

#undef ROB_ASK
#undef ROB_GO
#undef ROB_TURN
#undef ROB_IF
#undef ROB_CHECKED
#undef ROB_NEXT
#pragma GCC diagnostic pop

}  // namespace rob::lang
