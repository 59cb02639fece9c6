#include "lang/vm/persistent_values.h"

#include <algorithm>

#include "lang/values/value_text.h"

namespace rob::lang {

void PersistentValues::restore(const PersistCode& variable, std::size_t number,
                               Stack& stack) const {
  if (saved_ == nullptr || number >= saved_->size() || !(*saved_)[number]) return;
  const SavedValue& value = *(*saved_)[number];
  std::ranges::copy(value.numbers,
                    stack.numbers_at(variable.numbers, value.numbers.size()).begin());
  std::ranges::copy(value.texts, stack.texts_at(variable.texts, value.texts.size()).begin());
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
    const Slots slots = slots_of(variable.type);
    const auto numbers = static_cast<std::size_t>(slots.numbers);
    const auto texts = static_cast<std::size_t>(slots.texts);
    std::string text;
    too_large_ = !append_part_text(
        text, variable.type, stack.numbers_at(variable.numbers, numbers).data(),
        stack.texts_at(variable.texts, texts).data(), kMostPersistent, EnumNames::Alone);
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
