#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "lang/arithmetic.h"
#include "lang/chunk.h"

namespace rob::lang {

/// TASKs that a program can have, and the registers that the calls of each can take. [choice] they
/// look after things beside the program; a program of many small programs is another language.
inline constexpr std::size_t kMostTasks = 16;
inline constexpr std::size_t kTaskNumbers = 4096;
inline constexpr std::size_t kTaskTexts = 128;

/// What the TASKs of a program work on: the globals of its top level as they are in motion order,
/// and behind them a stack for each TASK.
class TaskMemory {
 public:
  explicit TaskMemory(const Chunk& chunk)
      : globals_(static_cast<std::size_t>(chunk.registers)),
        global_texts_(static_cast<std::size_t>(chunk.text_registers)),
        numbers_(globals_ + chunk.tasks.size() * kTaskNumbers),
        texts_(global_texts_ + chunk.tasks.size() * kTaskTexts) {}

  /// All up to the end of a TASK's stack.
  std::span<Slot> numbers(std::size_t task) {
    return std::span(numbers_).first(globals_ + (task + 1) * kTaskNumbers);
  }
  std::span<std::string> texts(std::size_t task) {
    return std::span(texts_).first(global_texts_ + (task + 1) * kTaskTexts);
  }

  void store(std::size_t first, std::span<const Slot> values) {
    std::ranges::copy(values, numbers_.begin() + static_cast<std::ptrdiff_t>(first));
  }
  void store(std::size_t first, std::span<const std::string> values) {
    std::ranges::copy(values, texts_.begin() + static_cast<std::ptrdiff_t>(first));
  }
  void load(std::size_t first, std::span<Slot> values) const {
    std::copy_n(numbers_.begin() + static_cast<std::ptrdiff_t>(first), values.size(),
                values.begin());
  }
  void load(std::size_t first, std::span<std::string> values) const {
    std::copy_n(texts_.begin() + static_cast<std::ptrdiff_t>(first), values.size(), values.begin());
  }

 private:
  std::size_t globals_;
  std::size_t global_texts_;
  std::vector<Slot> numbers_;
  std::vector<std::string> texts_;
};

}  // namespace rob::lang
