#include "lang/vm/lists.h"

#include <utility>

#include "lang/text/codes.h"

namespace rob::lang {
namespace {

std::size_t parts(int slots) { return static_cast<std::size_t>(slots); }

std::size_t weight_of(const ListElements& list, const std::string* texts, std::size_t count) {
  const std::size_t all = count * parts(list.size.texts);
  std::size_t bytes = count * parts(list.size.numbers) * sizeof(Slot) + all * sizeof(std::string);
  for (std::size_t i = 0; i < all; ++i) bytes += texts[i].size();
  return bytes;
}

std::size_t weight_of(const ListElements& list) {
  return weight_of(list, list.texts.data(), list.count);
}

Refusal held() {
  return {.code = std::string(code::kListHeld),
          .message = "this LIST cannot change its length: a REF to one of its elements is in use",
          .help = "give the routine the whole LIST by REF, and the index"};
}

Refusal full() {
  return {.code = std::string(code::kListFull),
          .message = "the LISTs hold 64 MiB, and there is no room for more",
          .help = "CLEAR those that are not needed any more"};
}

}  // namespace

std::int64_t Lists::open(std::int64_t home, std::size_t depth, Slots size) {
  drop(depth + 1);
  const auto [known, is_new] = numbers_.try_emplace({depth, home}, lists_.size());
  const std::size_t number = known->second;
  if (is_new) {
    lists_.emplace_back();
  } else {
    bytes_ -= weight_of(lists_[number]);
  }
  lists_[number] = {.home = home, .depth = depth, .size = size, .numbers = {}, .texts = {}};
  return static_cast<std::int64_t>(number);
}

void Lists::drop(std::size_t depth) {
  while (!lists_.empty() && lists_.back().depth >= depth) {
    bytes_ -= weight_of(lists_.back());
    numbers_.erase({lists_.back().depth, lists_.back().home});
    lists_.pop_back();
  }
}

Objection Lists::take(std::size_t bytes) {
  if (bytes > kMostListBytes - bytes_) return full();
  bytes_ += bytes;
  return {};
}

Objection Lists::append(ListElements& list, const Slot* numbers, const std::string* texts) {
  if (list.held > 0) return held();
  if (Objection why = take(weight_of(list, texts, 1))) return why;
  list.numbers.insert(list.numbers.end(), numbers, numbers + list.size.numbers);
  list.texts.insert(list.texts.end(), texts, texts + list.size.texts);
  ++list.count;
  return {};
}

Objection Lists::fill(ListElements& list, const Slot* numbers, const std::string* texts,
                      std::size_t count) {
  if (list.held > 0) return held();
  const std::size_t before = weight_of(list);
  const std::size_t now = weight_of(list, texts, count);
  if (Objection why = weigh(before, now)) return why;
  std::vector<Slot> new_numbers(numbers, numbers + count * parts(list.size.numbers));
  TextRow new_texts(texts, texts + count * parts(list.size.texts));
  list.numbers = std::move(new_numbers);
  list.texts = std::move(new_texts);
  list.count = count;
  return {};
}

Objection Lists::fill(ListElements& list, TextRow texts) {
  if (list.held > 0) return held();
  if (Objection why = weigh(weight_of(list), weight_of(list, texts.data(), texts.size()))) {
    return why;
  }
  list.count = texts.size();
  list.texts = std::move(texts);
  return {};
}

Objection Lists::remove(ListElements& list, std::size_t index) {
  if (list.held > 0) return held();
  const auto first = [&](auto& all, int size) {
    return all.begin() + static_cast<std::ptrdiff_t>(index * parts(size));
  };
  const auto number = first(list.numbers, list.size.numbers);
  const auto text = first(list.texts, list.size.texts);
  bytes_ -= weight_of(list, list.texts.data() + index * parts(list.size.texts), 1);
  list.numbers.erase(number, number + list.size.numbers);
  list.texts.erase(text, text + list.size.texts);
  --list.count;
  return {};
}

Objection Lists::clear(ListElements& list) {
  if (list.held > 0) return held();
  bytes_ -= weight_of(list);
  list.numbers = {};
  list.texts = {};
  list.count = 0;
  return {};
}

Objection Lists::weigh(std::size_t before, std::size_t now) {
  if (now > before) return take(now - before);
  bytes_ -= before - now;
  return {};
}

void Lists::hold(std::int64_t number, std::size_t depth) {
  const auto list = static_cast<std::size_t>(number);
  ++lists_[list].held;
  holds_.push_back({list, depth});
}

void Lists::release(std::size_t count) {
  for (; count > 0; --count) {
    const std::size_t list = holds_.back().list;
    if (list < lists_.size()) --lists_[list].held;
    holds_.pop_back();
  }
}

void Lists::release_from(std::size_t depth) {
  while (!holds_.empty() && holds_.back().depth >= depth) release(1);
}

}  // namespace rob::lang
