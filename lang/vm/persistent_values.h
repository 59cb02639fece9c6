#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

#include "lang/code/chunk.h"
#include "lang/machine/machine.h"
#include "lang/values/saved_value.h"
#include "lang/vm/stack.h"

namespace rob::lang {

/// The PERSIST variables whose values the machine does not know yet. Between two motions only the
/// last value of a variable counts, so the machine gets it before the next motion, and when a run
/// is left.
class PersistentValues {
 public:
  /// Before the run: what an earlier one has left. It must outlive this.
  void start_from(const SavedValues& saved) { saved_ = &saved; }
  /// `restore`, of a variable. Fails where its LIST finds no room.
  Objection restore(const PersistCode& variable, std::size_t number, Stack& stack) const;

  void change(std::size_t number) { changed_.insert(number); }
  /// A REF to it is out: it may change at any time.
  void lend(std::size_t number) { ++lent_[number]; }
  void take_back(std::size_t number);
  bool any() const { return !changed_.empty() || !lent_.empty(); }

  /// Hands the values to the machine. `Later`: it gets the next time what it could not take.
  Reply tell(Machine& machine, int line, const Chunk& chunk, Stack& stack);
  /// Of the last tell() that was Refused; else the machine's own counts.
  bool too_large() const { return too_large_; }

 private:
  const SavedValues* saved_ = nullptr;
  std::set<std::size_t> changed_;
  std::map<std::size_t, int> lent_;          ///< how often
  std::map<std::size_t, std::string> told_;  ///< of those that are lent
  bool too_large_ = false;
};

}  // namespace rob::lang
