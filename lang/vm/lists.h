#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "lang/values/arithmetic.h"
#include "lang/values/types.h"
#include "lang/vm/objection.h"

namespace rob::lang {

/// The most that all LISTs of a program may hold together, in bytes: 8 a number, 32 a text and its
/// letters.
inline constexpr std::size_t kMostListBytes = std::size_t{64} << 20;

/// Lies at a multiple of its own size. So a text of a list is a whole number of texts away from
/// those of the stack, and can have a place like them.
template <typename T>
struct AtMultiples {
  static_assert(std::has_single_bit(sizeof(T)));
  static constexpr std::align_val_t kBorder{sizeof(T)};

  using value_type = T;
  T* allocate(std::size_t count) {
    return static_cast<T*>(::operator new(count * sizeof(T), kBorder));
  }
  void deallocate(T* memory, std::size_t) noexcept { ::operator delete(memory, kBorder); }
  bool operator==(const AtMultiples&) const { return true; }
};
using TextRow = std::vector<std::string, AtMultiples<std::string>>;

/// The elements of a LIST, one after the other.
struct ListElements {
  std::int64_t home = 0;  ///< place of the slot that holds its number
  std::size_t depth = 0;  ///< of the frame that it is of
  Slots size;             ///< of an element
  std::size_t count = 0;
  std::size_t held = 0;  ///< REFs to its elements that are in use
  std::vector<Slot> numbers;
  TextRow texts;
};

/// The LISTs of all frames, those of the top level first. Their elements lie outside of the stack
/// and are moved where more room is needed: in the thread of the program, never in a control cycle.
class Lists {
 public:
  /// An empty list of the frame `depth` at that place, which it may have been before; its number.
  std::int64_t open(std::int64_t home, std::size_t depth, Slots size);
  /// Frames of this depth and deeper have been left.
  void drop(std::size_t depth);
  ListElements& operator[](std::int64_t number) { return lists_[static_cast<std::size_t>(number)]; }

  /// The element lies outside of the list. Each fails where a REF to an element is in use, or where
  /// there is no more room.
  Objection append(ListElements& list, const Slot* numbers, const std::string* texts);
  Objection fill(ListElements& list, const Slot* numbers, const std::string* texts,
                 std::size_t count);
  Objection fill(ListElements& list, TextRow texts);
  /// `index`: counted from 0.
  Objection remove(ListElements& list, std::size_t index);
  Objection clear(ListElements& list);
  /// A text of a list changes its size.
  Objection weigh(std::size_t before, std::size_t now);

  /// A REF to an element of the list is in use, by a call of the frame `depth`.
  void hold(std::int64_t number, std::size_t depth);
  void release(std::size_t count);
  /// The calls of the frame `depth`, and of those in it, have been left by an error.
  void release_from(std::size_t depth);

 private:
  struct Hold {
    std::size_t list;
    std::size_t depth;
  };
  Objection take(std::size_t bytes);

  std::deque<ListElements> lists_;
  /// The lists, by their frames and homes.
  std::map<std::pair<std::size_t, std::int64_t>, std::size_t> numbers_;
  std::vector<Hold> holds_;
  std::size_t bytes_ = 0;
};

}  // namespace rob::lang
