#include "lang/vm/rows.h"

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "lang/text/codes.h"
#include "lang/values/value_text.h"

namespace rob::lang {
namespace {

using Error = ArithmeticError;

std::size_t count_of(const Slot* row) { return static_cast<std::size_t>(row[2].integer); }

std::span<Slot> numbers_of(Stack& stack, const Slot* row) {
  return {stack.place(row[0], 0), count_of(row)};
}

std::span<std::string> texts_of(Stack& stack, const Slot* row) {
  return {stack.text_place(row[1], 0), count_of(row)};
}

Refusal nothing_in_row(RowNumber which) {
  return {
      .code = std::string(code::kEmptyRow),
      .message = std::string(which == RowNumber::Least ? "MIN" : "MAX") + " of no element at all",
      .help = "LEN says how many there are"};
}

template <typename Number, Number Slot::*kMember>
Objection compute(std::span<const Slot> row, RowNumber which, Slot& result) {
  if (which == RowNumber::Sum) {
    Number sum{};
    for (const Slot& each : row) {
      const Error error = arithmetic::add(sum, each.*kMember, sum);
      if (error != Error::None) return refusal_of(error);
    }
    result.*kMember = sum;
    return {};
  }
  if (row.empty()) return nothing_in_row(which);
  const auto found = which == RowNumber::Least ? std::ranges::min_element(row, {}, kMember)
                                               : std::ranges::max_element(row, {}, kMember);
  result = *found;
  return {};
}

/// Writes `[1, 2]`; false if the text would become too long.
bool append_elements(std::string& text, const Type& element, Stack& stack, const Slot* row) {
  const Slots size = slots_of(element);
  return append_row_text(text, element, count_of(row),
                         size.numbers > 0 ? stack.place(row[0], 0) : nullptr,
                         size.texts > 0 ? stack.text_place(row[1], 0) : nullptr, kMostText);
}

Objection join(std::span<const std::string> parts, const std::string& between,
               std::string& result) {
  std::string joined;
  for (const std::string& part : parts) {
    if (&part != parts.data()) joined += between;
    joined += part;
    if (joined.size() > kMostText) return text_too_long();
  }
  result = std::move(joined);
  return {};
}

Objection split(Lists& lists, ListElements& list, const std::string& text,
                const std::string& between) {
  if (between.empty()) {
    return Refusal{.code = std::string(code::kNoSeparator),
                   .message = "SPLIT needs at least one letter to split at",
                   .help = "as in SPLIT(line, \",\")"};
  }
  TextRow parts;
  std::size_t begin = 0;
  for (std::size_t end = 0; end != std::string::npos; begin = end + between.size()) {
    end = text.find(between, begin);
    parts.push_back(text.substr(begin, end - begin));
    if (end == std::string::npos) break;
  }
  return lists.fill(list, std::move(parts));
}

bool equal(const ListElements& a, const ListElements& b) {
  return a.count == b.count && a.texts == b.texts &&
         std::ranges::equal(a.numbers, b.numbers, {}, &Slot::integer, &Slot::integer);
}

const Instruction* step_list(const Instruction* pc, Stack& stack, Budget& budget, Objection& why) {
  Slot* const n = stack.numbers();
  const std::string* const t = stack.texts();
  Lists& lists = stack.lists();
  const auto list = [&] { return std::ref(stack.list_at(n[pc->a()])); };
  switch (pc->opcode()) {
    case Opcode::open_list:
      stack.open_list(n[pc->a()],
                      {static_cast<int>((pc + 1)->word), static_cast<int>((pc + 2)->word)});
      return pc + 3;
    case Opcode::fill_list: {
      const Slot* const row = &n[pc->b()];
      budget.charge(count_of(row));
      why = lists.fill(list(), stack.place(row[0], 0), stack.text_place(row[1], 0), count_of(row));
      return pc + 1;
    }
    case Opcode::append_list:
      why = lists.append(list(), stack.place(n[pc->b()], 0), stack.text_place(n[pc->c()], 0));
      return pc + 1;
    case Opcode::remove_list:
      budget.charge(list().get().count);
      why = lists.remove(list(), static_cast<std::size_t>(n[pc->b()].integer - 1));
      return pc + 1;
    case Opcode::clear_list:
      why = lists.clear(list());
      return pc + 1;
    case Opcode::equal_lists: {
      const ListElements& left = stack.list_at(n[pc->b()]);
      budget.charge(left.count);
      n[pc->a()].integer = equal(left, stack.list_at(n[pc->c()])) ? 1 : 0;
      return pc + 1;
    }
    case Opcode::split_text:
      budget.charge(t[pc->b()].size());
      why = split(lists, list(), t[pc->b()], t[pc->c()]);
      return pc + 1;
    case Opcode::hold_list:
      lists.hold(stack.place(n[pc->a()], 0)->integer, stack.depth());
      return pc + 1;
    case Opcode::release_lists:
      lists.release(pc->a());
      return pc + 1;
    default:
      return pc;
  }
}

}  // namespace

const Instruction* step_row(const Instruction* pc, const Chunk& chunk, Stack& stack, Budget& budget,
                            Objection& why) {
  Slot* const n = stack.numbers();
  const auto charged = [&](const Slot* row) {
    budget.charge(count_of(row));
    return row;
  };
  switch (pc->opcode()) {
    case Opcode::row_int:
      why = compute<std::int64_t, &Slot::integer>(numbers_of(stack, charged(&n[pc->b()])),
                                                  static_cast<RowNumber>(pc->c()), n[pc->a()]);
      return pc + 1;
    case Opcode::row_real:
      why = compute<double, &Slot::real>(numbers_of(stack, charged(&n[pc->b()])),
                                         static_cast<RowNumber>(pc->c()), n[pc->a()]);
      return pc + 1;
    case Opcode::sort_ints:
      std::ranges::sort(numbers_of(stack, charged(&n[pc->a()])), {}, &Slot::integer);
      return pc + 1;
    case Opcode::sort_reals:
      std::ranges::sort(numbers_of(stack, charged(&n[pc->a()])), {}, &Slot::real);
      return pc + 1;
    case Opcode::sort_texts:  // UTF-8 sorts by bytes as by code points
      std::ranges::sort(texts_of(stack, charged(&n[pc->a()])));
      return pc + 1;
    case Opcode::append_row: {
      std::string& text = stack.texts()[pc->a()];
      const std::size_t before = text.size();
      const Type& element = chunk.types[(pc + 1)->word];
      if (!append_elements(text, element, stack, charged(&n[pc->b()]))) why = text_too_long();
      budget.charge(text.size() - std::min(before, text.size()));
      return pc + 2;
    }
    case Opcode::join_row:
      why = join(texts_of(stack, charged(&n[pc->b()])), stack.texts()[pc->c()],
                 stack.texts()[pc->a()]);
      return pc + 1;
    default:
      return step_list(pc, stack, budget, why);
  }
}

}  // namespace rob::lang
