#include "lang/vm/turns.h"

namespace rob::lang {

/// The loops inside this one begin anew with each of its turns.
bool LoopTurns::count(Code end, Code first) {
  const Opcode before = (end - 2)->opcode();
  if (before == Opcode::for_next_int || before == Opcode::for_next_real) return true;
  loops_.erase(loops_.upper_bound(first), loops_.lower_bound(end));
  Turns& turns = loops_[first];
  if (turns.motions != motions_) turns = {0, motions_};
  if (++turns.count < most_) return true;
  circling_ = first;
  return false;
}

}  // namespace rob::lang
