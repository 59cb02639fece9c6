#include "lang/vm/vm.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "lang/values/builtins.h"
#include "lang/values/pose_functions.h"

// The dispatch loop. It holds what programs compute with; whatever talks to the machine, makes
// texts or is rare is in Vm::step(), out of the way: with few instructions here all that the loop
// needs stays in processor registers, the place of the current instruction before all.
//
// Computed goto, an extension that g++ and clang share: a jump of its own behind each instruction
// lets the processor predict the next one by the current one.
namespace rob::lang {

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"

#define ROB_NEXT(words)                                   \
  do {                                                    \
    pc += (words);                                        \
    goto* labels[static_cast<std::size_t>(pc->opcode())]; \
  } while (false)
#define ROB_CHECKED(operation)                       \
  do {                                               \
    error = (operation);                             \
    if (error != ArithmeticError::None) [[unlikely]] \
      goto failed_here;                              \
  } while (false)
#define ROB_ARITHMETIC(name, function, in, out)                                    \
  name:                                                                            \
  ROB_CHECKED(arithmetic::function(n[pc->b()].in, n[pc->c()].in, n[pc->a()].out)); \
  ROB_NEXT(1);
#define ROB_IF(name, condition, expected)                                                     \
  name:                                                                                       \
  if (static_cast<std::uint8_t>(condition) == (expected)) ROB_NEXT(2 + (pc + 1)->distance()); \
  ROB_NEXT(2)
// What jumps back pays for the way to here. `pc` is at the jump. Where the last one leads is known
// without waiting for its word: a loop is followed as fast as its turns can be guessed.
#define ROB_TURN()                         \
  do {                                     \
    if (pc != turn.at) [[unlikely]]        \
      goto other_turn;                     \
    pc = turn.to;                          \
    limit -= turn.cost;                    \
    turned_ = true;                        \
    if (limit <= address(pc)) [[unlikely]] \
      goto used_up;                        \
    ROB_NEXT(0);                           \
  } while (false)
// Into a routine or out of it. A recursion pays like a loop.
#define ROB_GO(words, target)               \
  do {                                      \
    const Code behind = pc + (words);       \
    pc = (target);                          \
    n = numbers_;                           \
    limit += address(pc) - address(behind); \
    if (limit <= address(pc)) [[unlikely]]  \
      goto used_up;                         \
    ROB_NEXT(0);                            \
  } while (false)

Vm::State Vm::execute(Code pc) {
  static constexpr const void* kLabels[] = {
#define ROB_OPCODE(name, operands) &&name,
#define ROB_STEP(name, operands) &&elsewhere,
#include "lang/code/opcodes.def"
  };
  const void* const* labels = kLabels;
  asm("" : "+r"(labels));  // else the address of the table is made anew for each instruction
  Slot* n = numbers_;
  const Slot* const constants = chunk_->constants.data();
  std::intptr_t limit = limit_;
  struct {
    Code at = nullptr;
    Code to = nullptr;
    std::intptr_t cost = 0;
  } turn;  // the last jump back
  ArithmeticError error;
  ROB_NEXT(0);

load_constant:
  n[pc->a()] = constants[pc->x()];
  ROB_NEXT(1);
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
pose_product:
  ROB_CHECKED(pose_functions::product(&n[pc->b()], &n[pc->c()], &n[pc->a()]));
  ROB_NEXT(1);
pose_transform:
  ROB_CHECKED(pose_functions::transformed(&n[pc->b()], &n[pc->c()], &n[pc->a()]));
  ROB_NEXT(1);

#include "lang/vm/vm_places.inc"

call:
  if (!enter(n + pc->a(), texts_ + pc->b(), (pc + 1)->word, pc + 2)) [[unlikely]]
    goto too_deep;
  ROB_GO(2, callees_[(pc + 1)->word].entry);
leave:
  ROB_GO(1, leave_routine());
leave_with:
  if (pc->b() == 1) {
    n[0] = n[pc->a()];
  } else {
    std::memmove(n, &n[pc->a()], pc->b() * sizeof(Slot));
  }
  ROB_GO(1, leave_routine());

jump:
  ROB_NEXT(1 + pc->distance());
loop:
  ROB_TURN();
  ROB_IF(if_bool, n[pc->a()].integer != 0, pc->b());
  ROB_IF(if_equal_int, n[pc->a()].integer == n[pc->b()].integer, pc->c());
  ROB_IF(if_less_int, n[pc->a()].integer < n[pc->b()].integer, pc->c());
  ROB_IF(if_less_equal_int, n[pc->a()].integer <= n[pc->b()].integer, pc->c());
  ROB_IF(if_equal_real, n[pc->a()].real == n[pc->b()].real, pc->c());
  ROB_IF(if_less_real, n[pc->a()].real < n[pc->b()].real, pc->c());
  ROB_IF(if_less_equal_real, n[pc->a()].real <= n[pc->b()].real, pc->c());

#include "lang/vm/vm_for.inc"

elsewhere : {
  limit_ = limit;
  const Step done = step(pc);
  if (done.next == nullptr) return done.left;
  pc = done.next;
  n = numbers_;
  limit = limit_;
  ROB_NEXT(0);
}
other_turn : {
  const Code jump = pc;
  pc += 1 + pc->distance();
  const std::intptr_t cost = address(jump + 1) - address(pc);
  limit -= cost;
  turned_ = true;
  if (limit <= address(pc)) goto used_up;
  if (most_turns_ == 0) {
    turn = {jump, pc, cost};
  } else if (!count_turn(jump + 1, pc)) {
    goto used_up;
  }
  ROB_NEXT(0);
}
used_up:
  limit_ = limit;
  return Vm::leave(pc, pc, State::Running);
failed_with_product:
  if (!std::isfinite(n[pc->c()].real * n[(pc + 1)->word].real)) goto failed_here;
failed_behind:
  ++pc;
failed_here:
  limit_ = limit;
  return fail(pc, error);
too_deep:
  limit_ = limit;
  return fail_calls_too_deep(pc);
out_of_range:
  limit_ = limit;
  return fail_index(pc, n[pc->b()].integer, (pc + 2)->word);
}

#undef ROB_GO
#undef ROB_TURN
#undef ROB_IF
#undef ROB_CHECKED
#undef ROB_NEXT
#pragma GCC diagnostic pop

}  // namespace rob::lang
