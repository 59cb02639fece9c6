#include "lang/vm/persistent_values.h"

#include <algorithm>

#include "lang/values/value_text.h"

namespace rob::lang {

namespace {

ListElements& list_of(const PersistCode& variable, Stack& stack) {
  return stack.list_at({.integer = static_cast<std::int64_t>(variable.numbers)});
}

/// As values files have it; false if it is too large.
bool append_current(std::string& text, const PersistCode& variable, Stack& stack) {
  if (variable.type.is(Type::Kind::List)) {
    const ListElements& list = list_of(variable, stack);
    return append_row_text(text, variable.type.detail->element, list.count, list.numbers.data(),
                           list.texts.data(), kMostPersistent, EnumNames::Alone);
  }
  const Slots slots = slots_of(variable.type);
  const auto numbers = static_cast<std::size_t>(slots.numbers);
  const auto texts = static_cast<std::size_t>(slots.texts);
  return append_part_text(text, variable.type, stack.numbers_at(variable.numbers, numbers).data(),
                          stack.texts_at(variable.texts, texts).data(), kMostPersistent,
                          EnumNames::Alone);
}

}  // namespace

Objection PersistentValues::restore(const PersistCode& variable, std::size_t number,
                                    Stack& stack) const {
  if (saved_ == nullptr || number >= saved_->size() || !(*saved_)[number]) return {};
  const SavedValue& value = *(*saved_)[number];
  if (variable.type.is(Type::Kind::List)) {
    return stack.lists().fill(list_of(variable, stack), value.numbers.data(), value.texts.data(),
                              value.count);
  }
  std::ranges::copy(value.numbers,
                    stack.numbers_at(variable.numbers, value.numbers.size()).begin());
  std::ranges::copy(value.texts, stack.texts_at(variable.texts, value.texts.size()).begin());
  return {};
}

void PersistentValues::take_back(std::size_t number) {
  changed_.insert(number);
  const auto lent = lent_.find(number);
  if (lent == lent_.end() || --lent->second > 0) return;
  lent_.erase(lent);
  told_.erase(number);
}

Reply PersistentValues::tell(Machine& machine, int line, const Chunk& chunk, Stack& stack) {
  for (const auto& [number, times] : lent_) changed_.insert(number);
  while (!changed_.empty()) {
    const std::size_t number = *changed_.begin();
    const PersistCode& variable = chunk.persists[number];
    std::string text;
    too_large_ = !append_current(text, variable, stack);
    if (too_large_) return Reply::Refused;
    const bool known = lent_.contains(number) && told_.contains(number) && told_[number] == text;
    if (!known) {
      const Reply reply = machine.persist(line, number, text);
      if (reply != Reply::Done) return reply;
    }
    if (lent_.contains(number)) told_[number] = std::move(text);
    changed_.erase(changed_.begin());
  }
  return Reply::Done;
}

}  // namespace rob::lang
