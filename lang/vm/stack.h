#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lang/code/chunk.h"
#include "lang/machine/machine.h"
#include "lang/values/arithmetic.h"
#include "lang/vm/lists.h"
#include "lang/vm/task_memory.h"

namespace rob::lang {

/// How deep calls may be nested. [choice] a recursion that goes deeper has most probably no end.
inline constexpr std::size_t kMostCalls = 1000;

/// Why no further one can be opened, and why none that needs memory of that much.
Refusal calls_too_deep();
Refusal memory_used_up(Slots room);

/// All that a call must know of a routine, together.
struct Callee {
  const Instruction* entry;
  std::int32_t registers;
  std::int32_t text_registers;
  std::int64_t called_in = 0;  ///< the cycle of its last call (Instant)
  const RoutineCode* routine;
  const Chunk* chunk;  ///< that it is of
};

/// One for each routine, by its number.
std::vector<Callee> callees_of(const Chunk& chunk);

/// The registers of all calls that are open, the frame of the top level first; then their memory,
/// in the same order. A reference is a place in it, which it keeps for good.
class Stack {
 public:
  /// The caller, where a call comes back to.
  struct Frame {
    const Instruction* back;
    Slot* numbers;
    std::string* texts;
    Slots memory;  ///< that was taken
    Callee* callee;
  };

  /// For a program.
  explicit Stack(const Chunk& chunk);
  /// For entries of the prompt.
  Stack();
  /// For a TASK: the end of what it sees of the shared memory.
  explicit Stack(TaskStack stack);
  Stack(const Stack&) = delete;
  Stack& operator=(const Stack&) = delete;

  /// The registers of the innermost frame.
  Slot* numbers() const { return numbers_; }
  std::string* texts() const { return texts_; }
  /// Registers of the top level.
  Slot& global(std::size_t index) { return number_stack_[index]; }
  std::string& global_text(std::size_t index) { return text_stack_[index]; }
  /// The place of a register.
  std::int64_t reference_to(const Slot* slot) const { return slot - number_stack_.data(); }
  std::int64_t reference_to(const std::string* text) const { return text - text_stack_.data(); }
  /// Where a reference leads, and some slots further.
  Slot* place(Slot reference, std::uint32_t offset) {
    return number_stack_.data() + reference.integer + offset;
  }
  std::string* text_place(Slot reference, std::uint32_t offset) {
    return text_stack_.data() + reference.integer + offset;
  }
  /// The slots from a place on.
  std::span<Slot> numbers_at(std::size_t place, std::size_t count) {
    return number_stack_.subspan(place, count);
  }
  std::span<std::string> texts_at(std::size_t place, std::size_t count) {
    return text_stack_.subspan(place, count);
  }

  /// Into a routine whose first registers these are; false if there is no room for its frame.
  bool enter(Slot* numbers, std::string* texts, Callee& callee, const Instruction* back);
  /// Back to the caller's frame; where its code goes on.
  const Instruction* leave();
  /// Leaves all calls beyond the first `depth`.
  void unwind(std::size_t depth);
  std::size_t depth() const { return static_cast<std::size_t>(frame_ - frames_.data()); }
  /// The calls that are open, the innermost last.
  std::span<const Frame> calls() const { return {frames_.data(), depth()}; }

  /// The LISTs of all frames. Their elements have places, too, which lead out of the stack.
  Lists& lists() { return *lists_; }
  ListElements& list_at(Slot home) { return (*lists_)[place(home, 0)->integer]; }
  /// Gives the slot at a place a list of the innermost frame.
  void open_list(Slot home, Slots size);
  /// Where the elements of a list lie, and how many they are, into three registers.
  void locate_list(Slot home, Slot* row);
  /// Texts of lists have become larger, or smaller, by as much; others do not count.
  Objection weigh(const std::string* at, std::size_t before, std::size_t now);

  /// Memory for the innermost frame; its places go to `place`. False if so much is not left.
  bool reserve(Slots slots, Slot* place);
  /// The top level begins anew.
  void release_memory() { memory_ = {}; }
  /// All the memory for arrays and records.
  Slots room() const;

 private:
  Stack(Slots registers, Slots memory, std::size_t calls);

  std::vector<Slot> own_numbers_;  ///< of a TASK: none
  TextRow own_texts_;
  std::span<Slot> number_stack_;
  std::span<std::string> text_stack_;
  Slots registers_;      ///< where registers end
  Slot* registers_end_;  ///< the same, as pointers
  std::string* text_registers_end_;
  Slots memory_;  ///< how much is taken of the memory after them
  std::vector<Frame> frames_;
  Frame* frame_;   ///< the next one that is free
  Slot* numbers_;  ///< the registers of the innermost frame
  std::string* texts_;
  Lists own_lists_;  ///< of a TASK: none
  Lists* lists_ = &own_lists_;
};

// In every call: here, so that the dispatch loop has them in line.

inline bool Stack::enter(Slot* numbers, std::string* texts, Callee& callee,
                         const Instruction* back) {
  if (frame_ == std::to_address(frames_.end()) || registers_end_ - numbers < callee.registers ||
      text_registers_end_ - texts < callee.text_registers) {
    return false;
  }
  // One by one: GCC would build a whole one elsewhere, and wait for that to copy it.
  frame_->back = back;
  frame_->numbers = numbers_;
  frame_->texts = texts_;
  frame_->memory = memory_;
  frame_->callee = &callee;
  ++frame_;
  numbers_ = numbers;
  texts_ = texts;
  return true;
}

inline const Instruction* Stack::leave() {
  const Frame& frame = *--frame_;
  numbers_ = frame.numbers;
  texts_ = frame.texts;
  memory_ = frame.memory;
  return frame.back;
}

}  // namespace rob::lang
