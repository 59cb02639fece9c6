#include "lang/vm/lists.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "lang/text/codes.h"

using rob::lang::kMostListBytes;
using rob::lang::ListElements;
using rob::lang::Lists;
using rob::lang::Objection;
using rob::lang::Slot;
using rob::lang::Slots;
using rob::lang::TextRow;

namespace {

constexpr Slots kNumber{.numbers = 1, .texts = 0};
constexpr Slots kText{.numbers = 0, .texts = 1};

bool is_full(const Objection& why) { return why && why->code == rob::lang::code::kListFull; }

}  // namespace

TEST_CASE("the LISTs hold 64 MiB together, and not an element more") {
  Lists lists;
  ListElements& numbers = lists[lists.open(0, 0, kNumber)];
  ListElements& texts = lists[lists.open(1, 0, kText)];
  const std::string text(1 << 20, 'x');
  // A text takes its letters and 32 bytes.
  constexpr std::size_t kFits = kMostListBytes / ((1 << 20) + 32);
  for (std::size_t i = 0; i < kFits; ++i) REQUIRE_FALSE(lists.append(texts, nullptr, &text));
  CHECK(kFits == 63);
  CHECK(is_full(lists.append(texts, nullptr, &text)));
  CHECK(texts.count == kFits);
  // What is left is for numbers of 8 bytes.
  constexpr std::size_t kNumbers = (kMostListBytes - kFits * ((1 << 20) + 32)) / 8;
  std::vector<Slot> many(kNumbers, Slot{.integer = 7});
  REQUIRE_FALSE(lists.fill(numbers, many.data(), nullptr, kNumbers));
  CHECK(is_full(lists.append(numbers, many.data(), nullptr)));
  CHECK(numbers.count == kNumbers);
  // A fill that has no room leaves the list as it was.
  many.push_back({.integer = 8});
  CHECK(is_full(lists.fill(numbers, many.data(), nullptr, many.size())));
  CHECK(numbers.count == kNumbers);
  CHECK(numbers.numbers.back().integer == 7);
}

TEST_CASE("what is removed, cleared or left makes room again") {
  Lists lists;
  ListElements& kept = lists[lists.open(0, 0, kText)];
  const std::string half(kMostListBytes / 2 - 32, 'x');
  REQUIRE_FALSE(lists.append(kept, nullptr, &half));
  REQUIRE_FALSE(lists.append(kept, nullptr, &half));
  const std::string empty;
  CHECK(is_full(lists.append(kept, nullptr, &empty)));
  REQUIRE_FALSE(lists.remove(kept, 0));
  ListElements& local = lists[lists.open(7, 1, kText)];
  REQUIRE_FALSE(lists.append(local, nullptr, &half));
  CHECK(is_full(lists.append(kept, nullptr, &empty)));
  lists.drop(1);  // the call is over
  REQUIRE_FALSE(lists.append(kept, nullptr, &half));
  CHECK(is_full(lists.weigh(1, 2)));
  REQUIRE_FALSE(lists.clear(kept));
  CHECK(kept.count == 0);
  TextRow two{half, half};
  CHECK_FALSE(lists.fill(kept, std::move(two)));
  CHECK(kept.count == 2);
}

TEST_CASE("a list whose element a REF holds keeps its length") {
  Lists lists;
  const std::int64_t number = lists.open(0, 0, kNumber);
  const Slot value{.integer = 1};
  REQUIRE_FALSE(lists.append(lists[number], &value, nullptr));
  lists.hold(number, 1);
  const auto is_held = [](const Objection& why) {
    return why && why->code == rob::lang::code::kListHeld;
  };
  CHECK(is_held(lists.append(lists[number], &value, nullptr)));
  CHECK(is_held(lists.remove(lists[number], 0)));
  CHECK(is_held(lists.clear(lists[number])));
  CHECK(is_held(lists.fill(lists[number], &value, nullptr, 1)));
  lists.release_from(1);
  CHECK_FALSE(lists.append(lists[number], &value, nullptr));
  CHECK(lists[number].count == 2);
}

TEST_CASE("a list that is opened again is the same one, among those of its frame alone") {
  Lists lists;
  const std::int64_t first = lists.open(0, 0, kNumber);
  const std::int64_t second = lists.open(1, 0, kNumber);
  const std::int64_t local = lists.open(2, 1, kNumber);
  CHECK(lists.open(2, 1, kNumber) == local);
  CHECK(lists.open(0, 0, kNumber) == first);  // the frame of the local one has been left
  CHECK(lists.open(1, 0, kNumber) == second);
  // At the same place, but of other frames.
  const std::int64_t deep = lists.open(2, 2, kNumber);
  CHECK(lists.open(2, 3, kNumber) != deep);
  CHECK(lists.open(2, 2, kNumber) == deep);
}
