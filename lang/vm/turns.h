#pragma once

#include <cstdint>
#include <functional>
#include <map>

#include "lang/code/chunk.h"

namespace rob::lang {

/// Counts how often loops turn without a motion, where that is limited.
class LoopTurns {
 public:
  using Code = const Instruction*;

  /// Lets no LOOP or WHILE turn more often than that, counted from where it was begun.
  void limit(std::uint32_t most) { most_ = most; }
  bool limited() const { return most_ != 0; }
  /// A motion was commanded.
  void moved() { ++motions_; }
  /// A loop turns: the jump that ends at `end` leads to its first instruction. False if it
  /// has turned too often. A FOR ends by itself: it is not counted.
  bool count(Code end, Code first);
  /// No loop begins there.
  void forget(Code first) { loops_.erase(first); }
  /// The first instruction of the loop that has turned too often; null if there is none.
  Code circling() const { return circling_; }

 private:
  struct Turns {
    std::uint32_t count = 0;
    std::uint64_t motions = 0;  ///< motions_ then
  };
  std::uint32_t most_ = 0;                    ///< 0: no limit
  std::uint64_t motions_ = 0;                 ///< commanded so far
  std::map<Code, Turns, std::less<>> loops_;  ///< by their first instructions
  Code circling_ = nullptr;
};

}  // namespace rob::lang
