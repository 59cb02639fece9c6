#pragma once

#include <cstdint>

#include "lang/code/chunk.h"

namespace rob::lang {

/// Slots of a long block that cost as much as an instruction. [choice] copying them takes as long.
inline constexpr std::uint32_t kSlotsAnInstruction = 16;

/// How many instructions a run may still execute, and how many have been executed.
///
/// The rest of the budget is kept as an address: where it is used up, were the code to go straight
/// on from here. So instructions pay by being passed, and only a jump back must reckon. The
/// dispatch loop keeps that limit in a variable of its own.
class Budget {
 public:
  using Code = const Instruction*;

  static constexpr std::intptr_t kWord = sizeof(Instruction);
  static std::intptr_t address(Code pc) { return reinterpret_cast<std::intptr_t>(pc); }

  explicit Budget(Code start) { go_on_at(start); }

  /// For a run from `next` on.
  void grant(std::int64_t instructions, Code next) {
    granted_ = instructions;
    go_on_at(next);
  }
  /// Execution has come to `pc`: what it has passed is paid.
  void settle(Code pc) {
    const std::int64_t left = (limit_ - address(pc)) / kWord;
    executed_ += granted_ - left;
    granted_ = left;
  }
  /// After settle(): where the code goes on, without cost.
  void go_on_at(Code next) { limit_ = address(next) + granted_ * kWord; }

  /// A jump to `next`, which ends at `end`; false if nothing is left there.
  bool jump(Code end, Code next) {
    limit_ += address(next) - address(end);
    return limit_ > address(next);
  }
  /// The cost of a block of slots, or of so many bytes of text.
  void charge(std::uint64_t slots) {
    limit_ -= static_cast<std::intptr_t>(slots / kSlotsAnInstruction) * kWord;
  }
  /// How many turns of so many words can still be paid at `pc`.
  std::int64_t turns_left(Code pc, std::int64_t words) const {
    return (limit_ - address(pc) - 1) / (words * kWord);
  }
  void pay(std::int64_t words) { limit_ -= words * kWord; }

  std::intptr_t limit() const { return limit_; }
  void set_limit(std::intptr_t limit) { limit_ = limit; }
  /// Since the start; those that a forward jump passed over count too.
  std::int64_t executed() const { return executed_; }

 private:
  std::int64_t executed_ = 0;  ///< up to the last settle()
  std::int64_t granted_ = 0;   ///< what was left then
  std::intptr_t limit_ = 0;
};

}  // namespace rob::lang
