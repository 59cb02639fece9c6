#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include "lang/ast.h"
#include "lang/diagnostic.h"
#include "lang/symbols.h"

namespace rob::lang {

/// Which routine uses which global and calls which routine. A routine sees all globals of its
/// file, but a call that stands above the declaration of one that it needs, itself or through what
/// it calls, would find it without a value: that is an error.
///
/// The checker tells what it meets; statements of the top level count from 1.
class RoutineUses {
 public:
  explicit RoutineUses(std::size_t routines) : callers_(routines) {}

  /// From here on things belong to `routine`, or to the top level where it is null.
  void enter(const Routine* routine) { inside_ = routine; }
  void next_statement() { ++statement_; }
  void declared(const Symbol& global) { declared_in_[&global] = statement_; }
  void used(const Symbol& symbol);
  void called(const Routine& routine, Place place);

  void report(Diagnostics& diagnostics) const;

 private:
  struct TopLevelCall {
    const Routine* routine;
    Place place;
    std::size_t statement;
  };
  std::vector<const Symbol*> latest_needs() const;

  const Routine* inside_ = nullptr;
  std::size_t statement_ = 0;
  std::map<const Symbol*, std::size_t> declared_in_;
  std::map<const Symbol*, std::set<std::size_t>> users_;  ///< routines by index
  std::vector<std::set<std::size_t>> callers_;            ///< of each routine
  std::vector<TopLevelCall> calls_;
};

}  // namespace rob::lang
