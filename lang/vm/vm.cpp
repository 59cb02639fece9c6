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
// Computed goto, an extension that g++ and clang share: a jump of its own after each instruction
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
// A jump back pays for the way to here. `pc` is at the jump. Where the last one leads is known
// without waiting for its word: a loop is followed as fast as its turns can be guessed.
#define ROB_TURN()                                 \
  do {                                             \
    if (pc != turn.at) [[unlikely]]                \
      goto other_turn;                             \
    pc = turn.to;                                  \
    limit -= turn.cost;                            \
    instant_.turn();                               \
    if (limit <= Budget::address(pc)) [[unlikely]] \
      goto used_up;                                \
    ROB_NEXT(0);                                   \
  } while (false)
// Into a routine or out of it. A recursion pays like a loop.
#define ROB_GO(words, target)                            \
  do {                                                   \
    const Code end = pc + (words);                       \
    pc = (target);                                       \
    n = stack_.numbers();                                \
    limit += Budget::address(pc) - Budget::address(end); \
    if (limit <= Budget::address(pc)) [[unlikely]]       \
      goto used_up;                                      \
    ROB_NEXT(0);                                         \
  } while (false)

Vm::State Vm::execute(Code pc) {
  static constexpr const void* kLabels[] = {
#define ROB_OPCODE(name, operands) &&name,
#define ROB_STEP(name, operands) &&elsewhere,
#define ROB_TEXT(name, operands) &&on_texts,
#include "lang/code/opcodes.def"
  };
  const void* const* labels = kLabels;
  asm("" : "+r"(labels));  // else the address of the table is made anew for each instruction
  Slot* n = stack_.numbers();
  const Slot* const constants = loaded_.chunk->constants.data();
  std::intptr_t limit = budget_.limit();
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

// Operations whose right side is a constant, or a product.
#define ROB_BY_CONSTANT(name, function, kind)                                                   \
  name:                                                                                         \
  ROB_CHECKED(arithmetic::function(n[pc->b()].kind, constants[pc->c()].kind, n[pc->a()].kind)); \
  ROB_NEXT(1)

  ROB_BY_CONSTANT(add_int_constant, add, integer);
  ROB_BY_CONSTANT(sub_int_constant, subtract, integer);
  ROB_BY_CONSTANT(mul_int_constant, multiply, integer);
  ROB_BY_CONSTANT(div_int_constant, floor_divide, integer);
  ROB_BY_CONSTANT(mod_int_constant, floor_modulo, integer);
  ROB_BY_CONSTANT(add_real_constant, add, real);
  ROB_BY_CONSTANT(sub_real_constant, subtract, real);
  ROB_BY_CONSTANT(mul_real_constant, multiply, real);
  ROB_BY_CONSTANT(quot_real_constant, divide, real);

  ROB_IF(if_equal_int_constant, n[pc->a()].integer == constants[pc->b()].integer, pc->c());
  ROB_IF(if_less_int_constant, n[pc->a()].integer < constants[pc->b()].integer, pc->c());
  ROB_IF(if_less_equal_int_constant, n[pc->a()].integer <= constants[pc->b()].integer, pc->c());
  ROB_IF(if_equal_real_constant, n[pc->a()].real == constants[pc->b()].real, pc->c());
  ROB_IF(if_less_real_constant, n[pc->a()].real < constants[pc->b()].real, pc->c());
  ROB_IF(if_less_equal_real_constant, n[pc->a()].real <= constants[pc->b()].real, pc->c());

#undef ROB_BY_CONSTANT

#define ROB_WITH_PRODUCT_INT(name, function)                                                   \
  name : {                                                                                     \
    std::int64_t product = 0;                                                                  \
    ROB_CHECKED(arithmetic::multiply(n[pc->c()].integer, n[(pc + 1)->word].integer, product)); \
    error = arithmetic::function(n[pc->b()].integer, product, n[pc->a()].integer);             \
    if (error != ArithmeticError::None) [[unlikely]]                                           \
      goto failed_after;                                                                       \
    ROB_NEXT(2);                                                                               \
  }
// A product that is not finite makes the sum so, and that it may be -0 is no matter in a sum.
#define ROB_WITH_PRODUCT_REAL(name, function)                                             \
  name:                                                                                   \
  error = arithmetic::function(n[pc->b()].real, n[pc->c()].real * n[(pc + 1)->word].real, \
                               n[pc->a()].real);                                          \
  if (error != ArithmeticError::None) [[unlikely]]                                        \
    goto failed_with_product;                                                             \
  ROB_NEXT(2)

  ROB_WITH_PRODUCT_INT(add_product_int, add);
  ROB_WITH_PRODUCT_INT(sub_product_int, subtract);
  ROB_WITH_PRODUCT_REAL(add_product_real, add);
  ROB_WITH_PRODUCT_REAL(sub_product_real, subtract);

// In a loop a result that goes through a register waits longer for it than for the sum: what is
// used at once stays in the processor. A part that is not finite makes the sum so, too; two
// products that are -0 make a -0, which store_finite() turns into 0.
#define ROB_OF_PRODUCTS(name, operation)                                                           \
  name:                                                                                            \
  error = arithmetic::store_finite(                                                                \
      n[pc->b()].real * n[pc->c()].real operation n[(pc + 1)->word].real * n[(pc + 2)->word].real, \
      n[pc->a()].real);                                                                            \
  if (error != ArithmeticError::None) [[unlikely]]                                                 \
    goto failed_of_products;                                                                       \
  ROB_NEXT(3)
#define ROB_OF_THREE(name, first, second)                                                    \
  name:                                                                                      \
  error = arithmetic::store_sum(                                                             \
      n[pc->b()].real first n[pc->c()].real second n[(pc + 1)->word].real, n[pc->a()].real); \
  if (error != ArithmeticError::None) [[unlikely]] {                                         \
    if (!std::isfinite(n[pc->b()].real first n[pc->c()].real)) goto failed_here;             \
    goto failed_after;                                                                       \
  }                                                                                          \
  ROB_NEXT(2)

  ROB_OF_PRODUCTS(add_products_real, +);
  ROB_OF_PRODUCTS(sub_products_real, -);
  ROB_OF_THREE(add_add_real, +, +);
  ROB_OF_THREE(add_sub_real, +, -);
  ROB_OF_THREE(sub_add_real, -, +);
  ROB_OF_THREE(sub_sub_real, -, -);

#undef ROB_OF_PRODUCTS
#undef ROB_OF_THREE
#undef ROB_WITH_PRODUCT_INT
#undef ROB_WITH_PRODUCT_REAL

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

// Through places: of variables that do not lie in registers of the frame, of elements and of
// references.
#define ROB_ELEMENT()                                                    \
  const auto which = static_cast<std::uint64_t>(n[pc->b()].integer) - 1; \
  if (which >= (pc + 2)->word) [[unlikely]]                              \
    goto out_of_range;                                                   \
  Slot* const element = stack_.place(n[pc->c()], (pc + 1)->word) + which

load_global:
  n[pc->a()] = stack_.global(pc->x());
  ROB_NEXT(1);
store_global:
  stack_.global(pc->x()) = n[pc->a()];
  ROB_NEXT(1);
refer:
  n[pc->a()].integer = stack_.reference_to(&n[pc->b()]);
  ROB_NEXT(1);
load_reference:
  std::copy_n(stack_.place(n[pc->b()], (pc + 1)->word), pc->c(), &n[pc->a()]);
  ROB_NEXT(2);
store_reference:
  std::copy_n(&n[pc->a()], pc->c(), stack_.place(n[pc->b()], (pc + 1)->word));
  ROB_NEXT(2);
load_slot:
  n[pc->a()] = *stack_.place(n[pc->b()], (pc + 1)->word);
  ROB_NEXT(2);
store_slot:
  *stack_.place(n[pc->b()], (pc + 1)->word) = n[pc->a()];
  ROB_NEXT(2);
place_behind:
  n[pc->a()].integer = n[pc->b()].integer + (pc + 1)->word;
  ROB_NEXT(2);
element : {
  const auto which = static_cast<std::uint64_t>(n[pc->b()].integer) - 1;
  if (which >= (pc + 2)->word) [[unlikely]]
    goto out_of_range;
  n[pc->a()].integer =
      n[pc->c()].integer + (pc + 1)->word + static_cast<std::int64_t>(which) * (pc + 3)->word;
  ROB_NEXT(4);
}
list_row:
  stack_.locate_list(n[pc->b()], &n[pc->a()]);
  ROB_NEXT(1);
check_index : {
  const auto which = static_cast<std::uint64_t>(n[pc->a()].integer) - 1;
  if (which >= static_cast<std::uint64_t>(n[pc->b()].integer)) [[unlikely]]
    goto out_of_row;
  ROB_NEXT(1);
}
load_element : {
  ROB_ELEMENT();
  n[pc->a()] = *element;
  ROB_NEXT(3);
}
store_element : {
  ROB_ELEMENT();
  *element = n[pc->a()];
  ROB_NEXT(3);
}
store_element_constant : {
  ROB_ELEMENT();
  *element = constants[pc->a()];
  ROB_NEXT(3);
}

#undef ROB_ELEMENT

#define ROB_FIELD()                                                      \
  const auto which = static_cast<std::uint64_t>(n[pc->b()].integer) - 1; \
  if (which >= (pc + 2)->word) [[unlikely]]                              \
    goto out_of_range;                                                   \
  Slot* const field = stack_.place(n[pc->c()], (pc + 1)->word) + which * (pc + 3)->word

load_field : {
  ROB_FIELD();
  n[pc->a()] = *field;
  ROB_NEXT(4);
}
store_field : {
  ROB_FIELD();
  *field = n[pc->a()];
  ROB_NEXT(4);
}
#define ROB_CELL()                                                              \
  ROB_FIELD();                                                                  \
  const auto inner = static_cast<std::uint64_t>(n[(pc + 4)->word].integer) - 1; \
  if (inner >= (pc + 5)->word) [[unlikely]]                                     \
  goto inner_out_of_range

load_cell : {
  ROB_CELL();
  n[pc->a()] = field[inner];
  ROB_NEXT(6);
}
store_cell : {
  ROB_CELL();
  field[inner] = n[pc->a()];
  ROB_NEXT(6);
}

#undef ROB_CELL
#undef ROB_FIELD

call:
  if (!enter(n + pc->a(), stack_.texts() + pc->b(), (pc + 1)->word, pc + 2)) [[unlikely]]
    goto too_deep;
  ROB_GO(2, loaded_.callees[(pc + 1)->word].entry);
leave:
  ROB_GO(1, stack_.leave());
leave_with:
  if (pc->b() == 1) {
    n[0] = n[pc->a()];
  } else {
    std::memmove(n, &n[pc->a()], pc->b() * sizeof(Slot));
  }
  ROB_GO(1, stack_.leave());

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

// FOR. opcodes.def says what lies in its registers. No pointer to them lives on after a call of a
// function: it would take a processor register from the whole loop.
for_prepare_int : {
  const Slot* const f = &n[pc->a()];
  ROB_CHECKED(arithmetic::turns(f[0].integer, f[1].integer, f[2].integer, n[pc->a() + 1].integer));
  if (n[pc->a() + 1].integer == 0) ROB_NEXT(2 + (pc + 1)->distance());
  n[pc->a() + 1].integer -= 1;
  ROB_NEXT(2);
}
for_next_int : {
  Slot* const f = &n[pc->a()];
  if (--f[1].integer < 0) ROB_NEXT(2);
  f[0].integer += f[2].integer;
  ++pc;
  ROB_TURN();
}
for_prepare_real : {
  const Slot* const first = &n[pc->a()];
  ROB_CHECKED(
      arithmetic::turns(first[0].real, first[1].real, first[2].real, n[pc->a() + 1].integer));
  if (n[pc->a() + 1].integer == 0) ROB_NEXT(2 + (pc + 1)->distance());
  Slot* const f = &n[pc->a()];
  f[1].integer -= 1;
  f[3].real = f[0].real;
  f[4].real = 0;
  ROB_NEXT(2);
}
for_next_real : {
  Slot* const f = &n[pc->a()];
  if (--f[1].integer < 0) ROB_NEXT(2);
  f[4].real += 1;
  f[0].real = f[3].real + f[4].real * f[2].real;
  ++pc;
  ROB_TURN();
}

on_texts : {
  budget_.set_limit(limit);
  const Step done = compute_on_texts(pc);
  if (done.next == nullptr) return done.left;
  pc = done.next;
  ROB_NEXT(0);
}
elsewhere : {
  budget_.set_limit(limit);
  const Step done = step(pc);
  if (done.next == nullptr) return done.left;
  pc = done.next;
  n = stack_.numbers();
  limit = budget_.limit();
  ROB_NEXT(0);
}
other_turn : {
  const Code jump = pc;
  pc += 1 + pc->distance();
  const std::intptr_t cost = Budget::address(jump + 1) - Budget::address(pc);
  limit -= cost;
  instant_.turn();
  if (limit <= Budget::address(pc)) goto used_up;
  if (!turns_.limited()) {
    turn = {jump, pc, cost};
  } else if (!turns_.count(jump + 1, pc)) {
    goto used_up;
  }
  ROB_NEXT(0);
}
used_up:
  budget_.set_limit(limit);
  return Vm::leave(pc, pc, State::Running);
failed_of_products:
  if (!std::isfinite(n[pc->b()].real * n[pc->c()].real)) goto failed_here;
  ++pc;
  if (!std::isfinite(n[pc->word].real * n[(pc + 1)->word].real)) goto failed_here;
  goto failed_after;
failed_with_product:
  if (!std::isfinite(n[pc->c()].real * n[(pc + 1)->word].real)) goto failed_here;
failed_after:
  ++pc;
failed_here:
  budget_.set_limit(limit);
  return fail(pc, error);
too_deep:
  budget_.set_limit(limit);
  return fail_calls_too_deep(pc);
out_of_range:
  budget_.set_limit(limit);
  return fail_index(pc, n[pc->b()].integer, (pc + 2)->word);
inner_out_of_range:
  budget_.set_limit(limit);
  return fail_index(pc + 4, n[(pc + 4)->word].integer, (pc + 5)->word);
out_of_row:
  budget_.set_limit(limit);
  return fail_index(pc, n[pc->a()].integer, n[pc->b()].integer);
}

#undef ROB_GO
#undef ROB_TURN
#undef ROB_IF
#undef ROB_CHECKED
#undef ROB_NEXT
#pragma GCC diagnostic pop

}  // namespace rob::lang
