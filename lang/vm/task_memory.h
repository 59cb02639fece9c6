#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "lang/code/chunk.h"
#include "lang/machine/machine.h"
#include "lang/values/arithmetic.h"
#include "lang/vm/lists.h"

namespace rob::lang {

/// The registers that the calls of a TASK can take, and the memory, if any routine takes some.
/// [choice] it looks after something beside the program.
inline constexpr Slots kTaskRegisters{.numbers = 4096, .texts = 128};
inline constexpr Slots kTaskOwnMemory{.numbers = 16384, .texts = 256};

/// The memory of all TASKs of a program: the globals of its top level as they are in motion order,
/// at the same places as in the program's own stacks, and after them a stack for each TASK.
class TaskMemory {
 public:
  explicit TaskMemory(const Chunk& chunk)
      : globals_(Slots{static_cast<int>(kNumberStack), static_cast<int>(kTextStack)} +
                 chunk.memory),
        stack_(kTaskRegisters + (takes_memory(chunk) ? kTaskOwnMemory : Slots{})),
        tasks_(chunk.tasks.size()) {
    if (tasks_ > 0) open();
  }
  /// For the TASKs of a prompt's entries: with room for all that entries may declare.
  TaskMemory()
      : globals_(Slots{static_cast<int>(kNumberStack), static_cast<int>(kTextStack)} + kMemory),
        stack_(kTaskRegisters + kTaskOwnMemory),
        tasks_(kMostTasks) {}
  /// There are TASKs.
  void open() {
    numbers_.resize(size(stack_begin(tasks_).numbers));
    texts_.resize(size(stack_begin(tasks_).texts));
  }

  /// Where the registers of a stack begin; they end kTaskRegisters further on, and its memory
  /// follows.
  Slots stack_begin(std::size_t stack) const {
    const int before = static_cast<int>(stack);
    return globals_ + Slots{before * stack_.numbers, before * stack_.texts};
  }
  /// All up to the end of a stack.
  std::span<Slot> numbers(std::size_t stack) {
    return std::span(numbers_).first(size(stack_begin(stack + 1).numbers));
  }
  std::span<std::string> texts(std::size_t stack) {
    return std::span(texts_).first(size(stack_begin(stack + 1).texts));
  }

  void store(std::size_t first, std::span<const Slot> values) {
    std::ranges::copy(values, numbers_.begin() + static_cast<std::ptrdiff_t>(first));
  }
  void store(std::size_t first, std::span<const std::string> values) {
    std::ranges::copy(values, texts_.begin() + static_cast<std::ptrdiff_t>(first));
  }
  /// All of them have room together: the program has no more.
  void store_list(std::size_t home, const ListContent& list) {
    const auto place = static_cast<std::int64_t>(home);
    numbers_[home].integer = lists_.open(place, 0, list.size);
    lists_.fill(lists_[numbers_[home].integer], list.numbers.data(), list.texts.data(), list.count);
  }
  /// Those of the top level. TASKs look at them, and have none of their own.
  Lists& lists() { return lists_; }
  void load(std::size_t first, std::span<Slot> values) const {
    std::copy_n(numbers_.begin() + static_cast<std::ptrdiff_t>(first), values.size(),
                values.begin());
  }
  void load(std::size_t first, std::span<std::string> values) const {
    std::copy_n(texts_.begin() + static_cast<std::ptrdiff_t>(first), values.size(), values.begin());
  }

 private:
  static std::size_t size(int slots) { return static_cast<std::size_t>(slots); }

  Slots globals_;
  Slots stack_;  ///< of each TASK
  std::size_t tasks_;
  std::vector<Slot> numbers_;
  TextRow texts_;
  Lists lists_;
};

/// A stack in it, by its number, for one TASK.
struct TaskStack {
  TaskMemory& memory;
  std::size_t number;
};

}  // namespace rob::lang
