#include <algorithm>
#include <cstdint>

#include "lang/vm/vm.h"

/// Member functions of Vm that execute a FOR whose body only stores into one element of an array.
namespace rob::lang {
namespace {

/// fill_element itself, for_next_int and loop.
constexpr std::int64_t kWordsATurn = 3 + 1 + 1;

/// How many steps stay between 0 and `length` - 1.
std::int64_t steps_within(std::uint64_t index, std::int64_t step, std::uint64_t length) {
  const auto by = static_cast<std::uint64_t>(step);
  return static_cast<std::int64_t>(step < 0 ? index / (0 - by) : (length - 1 - index) / by);
}

}  // namespace

/// Stores, and makes at once those turns of the loop around it that neither the budget nor the
/// array's end stops; they cost what they would cost one by one.
Vm::Step Vm::fill(Code pc, Slot value) {
  Slot* const loop = &numbers_[pc->b()];
  const std::uint32_t length = (pc + 2)->word;
  const auto which = static_cast<std::uint64_t>(loop[0].integer) - 1;
  if (which >= length) return fail_index(pc, loop[0].integer, length);
  Slot* element = place_of(numbers_[pc->c()], (pc + 1)->word) + which;
  *element = value;
  if (loop[1].integer == 0) return pc + 3;
  const std::int64_t step = loop[2].integer;
  const std::int64_t paid = (limit_ - address(pc) - 1) / (kWordsATurn * kWord);
  const std::int64_t turns = std::max<std::int64_t>(
      0, std::min({loop[1].integer, steps_within(which, step, length), paid}));
  for (std::int64_t turn = 0; turn < turns; ++turn) *(element += step) = value;
  loop[0].integer += turns * step;
  loop[1].integer -= turns;
  limit_ -= turns * kWordsATurn * kWord;
  turned_ = turned_ || turns > 0;
  return pc + 3;
}

}  // namespace rob::lang
