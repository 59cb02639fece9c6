#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lang/code/chunk.h"
#include "lang/code/frame_slots.h"

namespace rob::lang {

/// The last `element` of the code that is made: it may become one instruction with what follows.
class LastElement {
 public:
  explicit LastElement(std::vector<Instruction>& code) : code_(code) {}

  /// One ends here.
  void ends() { end_ = code_.size(); }
  /// Something else reads its register, or code jumps to its end: it stays.
  void keep() { end_ = 0; }
  /// Makes one instruction of it and what follows, if it is the last instruction and has the place
  /// in register `at`, which nothing else reads: what lies so far after that place, from or into
  /// `value`. Whether it was so.
  bool join(Opcode opcode, Register value, Register at, std::uint32_t offset) {
    constexpr std::size_t kWords = 4;
    if (end_ == 0 || end_ != code_.size()) return false;
    Instruction& element = code_[end_ - kWords];
    if (element.a() != at) return false;
    element = Instruction::abc(opcode, value, element.b(), element.c());
    code_[end_ - kWords + 1].word += offset;
    end_ = 0;
    return true;
  }

 private:
  std::vector<Instruction>& code_;
  std::size_t end_ = 0;
};

}  // namespace rob::lang
