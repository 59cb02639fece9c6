#include "lang/vm/value_instructions.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "lang/text/codes.h"
#include "lang/text/utf8.h"
#include "lang/values/builtins.h"
#include "lang/values/csv.h"
#include "lang/values/number_text.h"
#include "lang/values/pose_functions.h"
#include "lang/values/text_functions.h"
#include "lang/values/value_text.h"
#include "lang/vm/rows.h"

namespace rob::lang {
namespace {

using Code = const Instruction*;

using text_functions::kMostText;

bool equal_slots(const Slot* a, const Slot* b, std::size_t count) {
  return std::memcmp(a, b, count * sizeof(Slot)) == 0;
}

std::size_t letters(const std::string* texts, std::size_t count) {
  return std::accumulate(texts, texts + count, std::size_t{0},
                         [](std::size_t sum, const std::string& one) { return sum + one.size(); });
}

Objection copy_texts(Stack& stack, std::string* to, const std::string* from, std::size_t count) {
  if (Objection why = stack.weigh(to, letters(to, count), letters(from, count))) return why;
  if (to < from) {
    std::copy(from, from + count, to);
  } else if (to > from) {
    std::copy_backward(from, from + count, to + count);
  }
  return {};
}

/// False, and the text stays as it is, if it would become too long.
bool append(std::string& text, std::string_view more) {
  if (text.size() + more.size() > kMostText) return false;
  text += more;
  return true;
}

/// The same of two texts; `target` may be one of them.
bool join(std::string& target, const std::string& left, const std::string& right) {
  if (left.size() + right.size() > kMostText) return false;
  if (&target == &right) {
    target.insert(0, left);
  } else {
    if (&target != &left) target = left;
    target += right;
  }
  return true;
}

Objection objection(ArithmeticError error) {
  if (error == ArithmeticError::None) return {};
  return refusal_of(error);
}

/// `append`: append_value_text or append_csv.
template <typename Append>
bool append_memory(Code pc, const Chunk& chunk, Stack& stack, Budget& budget, Append append) {
  const Slot* const n = stack.numbers();
  std::string& text = stack.texts()[pc->a()];
  const std::size_t before = text.size();
  const Type& type = chunk.types[(pc + 1)->word];
  const Slots slots = slots_of(type);
  const bool fits = append(text, type, slots.numbers > 0 ? stack.place(n[pc->b()], 0) : nullptr,
                           slots.texts > 0 ? stack.text_place(n[pc->c()], 0) : nullptr, kMostText);
  budget.charge(text.size() - before);
  return fits;
}

/// Single texts that do not lie in registers of the frame.
Code step_text_place(Code pc, Stack& stack, Objection& why) {
  Slot* const n = stack.numbers();
  std::string* const t = stack.texts();
  switch (pc->opcode()) {
    case Opcode::load_global_text:
      t[pc->a()] = stack.global_text(pc->x());
      return pc + 1;
    case Opcode::store_global_text:
      stack.global_text(pc->x()) = t[pc->a()];
      return pc + 1;
    case Opcode::load_reference_text:
      t[pc->a()] = *stack.text_place(n[pc->b()], (pc + 1)->word);
      return pc + 2;
    case Opcode::store_reference_text: {
      std::string& text = *stack.text_place(n[pc->b()], (pc + 1)->word);
      why = stack.weigh(&text, text.size(), t[pc->a()].size());
      if (!why) text = t[pc->a()];
      return pc + 2;
    }
    default:
      return pc;
  }
}

/// Rows of texts that do not lie in registers of the frame, and values as texts.
Code step_texts(Code pc, const Chunk& chunk, Stack& stack, Budget& budget, Objection& why) {
  Slot* const n = stack.numbers();
  std::string* const t = stack.texts();
  const auto grown = [&](bool fits) {
    if (!fits) why = text_too_long();
    return pc + 2;
  };
  switch (pc->opcode()) {
    case Opcode::refer_text:
      n[pc->a()].integer = stack.reference_to(&t[pc->b()]);
      return pc + 1;
    case Opcode::clear_texts:
      budget.charge((pc + 2)->word);
      std::fill_n(stack.text_place(n[pc->a()], (pc + 1)->word), (pc + 2)->word, std::string());
      return pc + 3;
    case Opcode::copy_texts:
      budget.charge((pc + 3)->word);
      why = copy_texts(stack, stack.text_place(n[pc->a()], (pc + 1)->word),
                       stack.text_place(n[pc->b()], (pc + 2)->word), (pc + 3)->word);
      return pc + 4;
    case Opcode::equal_texts: {
      budget.charge((pc + 1)->word);
      const std::string* const texts = stack.text_place(n[pc->b()], 0);
      const bool equal = std::equal(texts, texts + (pc + 1)->word, stack.text_place(n[pc->c()], 0));
      n[pc->a()].integer = equal ? 1 : 0;
      return pc + 2;
    }
    case Opcode::append_value: {
      const Type& type = chunk.types[(pc + 1)->word];
      return grown(append_value_text(t[pc->a()], type, &n[pc->b()], nullptr, kMostText));
    }
    case Opcode::append_memory:
      return grown(append_memory(pc, chunk, stack, budget, append_value_text));
    case Opcode::append_csv:
      return grown(append_memory(pc, chunk, stack, budget, append_csv));
    default:
      return pc;
  }
}

}  // namespace

const Instruction* step_text(const Instruction* pc, const Chunk& chunk, Stack& stack,
                             Objection& why) {
  Slot* const n = stack.numbers();
  std::string* const t = stack.texts();
  const auto grown = [&](bool fits, int words) {
    if (!fits) why = text_too_long();
    return pc + words;
  };
  switch (pc->opcode()) {
    case Opcode::load_text:
      t[pc->a()] = chunk.texts[(pc + 1)->word];
      return pc + 2;
    case Opcode::copy_text:
      t[pc->a()] = t[pc->b()];
      return pc + 1;
    case Opcode::take_text:
      t[pc->a()].swap(t[pc->b()]);
      return pc + 1;
    case Opcode::join_text:
      return grown(join(t[pc->a()], t[pc->b()], t[pc->c()]), 1);
    case Opcode::append_constant:
      return grown(append(t[pc->a()], chunk.texts[(pc + 1)->word]), 2);
    case Opcode::append_text:
      return grown(append(t[pc->a()], t[pc->b()]), 1);
    case Opcode::append_int:
      return grown(append(t[pc->a()], std::to_string(n[pc->b()].integer)), 1);
    case Opcode::append_real: {
      const Dimension dimension = chunk.dimensions[pc->c()];
      return grown(append(t[pc->a()], number_text(n[pc->b()].real, dimension)), 1);
    }
    case Opcode::append_bool:
      return grown(append(t[pc->a()], text_of(n[pc->b()].integer != 0)), 1);
    case Opcode::call_text:
      why = objection(builtins()[pc->c()].text(&n[pc->a()], &t[pc->b()]));
      return pc + 1;
    case Opcode::equal_text:
      n[pc->a()].integer = t[pc->b()] == t[pc->c()] ? 1 : 0;
      return pc + 1;
    case Opcode::equal_text_constant:
      n[pc->a()].integer = t[pc->b()] == chunk.texts[(pc + 1)->word] ? 1 : 0;
      return pc + 2;
    case Opcode::text_length:
      n[pc->a()].integer = count_code_points(t[pc->b()]);
      return pc + 1;
    case Opcode::text_middle: {
      const Slot* const range = &n[pc->c()];
      const auto part = text_functions::part_of(t[pc->b()], range[0].integer, range[1].integer);
      t[pc->a()].assign(part.data(), part.size());
      return pc + 1;
    }
    case Opcode::text_find:
      n[pc->a()].integer = text_functions::position_in(t[pc->b()], t[pc->c()]);
      return pc + 1;
    case Opcode::less_text:  // UTF-8 sorts by bytes as by code points
      n[pc->a()].integer = t[pc->b()] < t[pc->c()] ? 1 : 0;
      return pc + 1;
    case Opcode::less_equal_text:
      n[pc->a()].integer = t[pc->b()] <= t[pc->c()] ? 1 : 0;
      return pc + 1;
    default:
      return step_text_place(pc, stack, why);
  }
}

const Instruction* step_value(const Instruction* pc, const Chunk& chunk, Stack& stack,
                              Budget& budget, Objection& why) {
  Slot* const n = stack.numbers();
  switch (pc->opcode()) {
    case Opcode::load_constant_wide:
      n[pc->a()] = chunk.constants[(pc + 1)->word];
      return pc + 2;
    case Opcode::pose_angle:
      pose_functions::angle(&n[pc->b()], pc->c(), n[pc->a()]);
      return pc + 1;
    case Opcode::reserve: {
      const Slots wanted{static_cast<int>((pc + 1)->word), static_cast<int>((pc + 2)->word)};
      if (!stack.reserve(wanted, &n[pc->a()])) why = memory_used_up(stack.room());
      return pc + 3;
    }
    case Opcode::clear_memory:
      budget.charge((pc + 2)->word);
      std::fill_n(stack.place(n[pc->a()], (pc + 1)->word), (pc + 2)->word, Slot{.integer = 0});
      return pc + 3;
    case Opcode::copy_memory:
      budget.charge((pc + 3)->word);
      std::memmove(stack.place(n[pc->a()], (pc + 1)->word), stack.place(n[pc->b()], (pc + 2)->word),
                   (pc + 3)->word * sizeof(Slot));
      return pc + 4;
    case Opcode::equal_memory: {
      budget.charge((pc + 1)->word);
      const bool equal =
          equal_slots(stack.place(n[pc->b()], 0), stack.place(n[pc->c()], 0), (pc + 1)->word);
      n[pc->a()].integer = equal ? 1 : 0;
      return pc + 2;
    }
    case Opcode::equal_block:
      n[pc->a()].integer = equal_slots(&n[pc->b()], &n[pc->c()], (pc + 1)->word) ? 1 : 0;
      return pc + 2;
    default: {
      const Code next = step_texts(pc, chunk, stack, budget, why);
      return next != pc ? next : step_row(pc, chunk, stack, budget, why);
    }
  }
}

}  // namespace rob::lang
