#include "lang/check/return_paths.h"

#include <algorithm>

namespace rob::lang {
namespace {

bool has_exit(const Block& block);
bool has_return(const Block& block);

/// Looks for a statement in a block and what it holds. EXIT of an inner loop is not one of the
/// outer, so for EXIT inner loops are passed over.
struct Search {
  bool exits;

  bool operator()(const Exit&) const { return exits; }
  bool operator()(const Return&) const { return !exits; }
  bool operator()(const If& conditional) const {
    return in(conditional.otherwise) ||
           std::ranges::any_of(conditional.branches, [&](auto& one) { return in(one.body); });
  }
  bool operator()(const Select& select) const {
    return in(select.otherwise) ||
           std::ranges::any_of(select.cases, [&](auto& one) { return in(one.body); });
  }
  bool operator()(const Try& guarded) const { return in(guarded.body) || in(guarded.rescue); }
  bool operator()(const Wait& wait) const { return in(wait.otherwise); }
  bool operator()(const WatchedMotion& watched) const { return in(watched.otherwise); }
  bool operator()(const With& with) const { return in(with.body); }
  bool operator()(const Press& press) const { return in(press.body); }
  bool operator()(const While& loop) const { return !exits && in(loop.body); }
  bool operator()(const For& loop) const { return !exits && in(loop.body); }
  bool operator()(const Loop& loop) const { return !exits && in(loop.body); }
  template <typename Other>
  bool operator()(const Other&) const {
    return false;
  }

  bool in(const Block& block) const { return exits ? has_exit(block) : has_return(block); }
};

bool holds(const Block& block, const Search& search) {
  return std::ranges::any_of(
      block, [&](const Statement& statement) { return std::visit(search, statement.node); });
}
bool has_exit(const Block& block) { return holds(block, {.exits = true}); }
bool has_return(const Block& block) { return holds(block, {.exits = false}); }

/// Branches of which one is taken; without an ELSE the way past them counts where one of them
/// comes to its end, too.
class Branches {
 public:
  void add(const Block& block) { add(ending_of(block)); }
  void add(Ending ending) { most_ = std::max(most_, ending); }
  Ending result(bool complete) const { return complete ? most_ : std::max(most_, Ending::Maybe); }

 private:
  Ending most_ = Ending::Never;
};

/// An ELSE that is taken where something did not happen in time.
Ending behind_else(const Block& otherwise) {
  Branches branches;
  branches.add(otherwise);
  return branches.result(false);
}

struct EndingOf {
  Ending operator()(const Return&) const { return Ending::Never; }
  Ending operator()(const Exit&) const { return Ending::Never; }
  Ending operator()(const Next&) const { return Ending::Never; }
  Ending operator()(const Raise&) const { return Ending::Never; }
  Ending operator()(const Try& guarded) const {
    Branches branches;
    branches.add(guarded.body);
    branches.add(guarded.rescue);
    return branches.result(true);
  }
  Ending operator()(const If& conditional) const {
    Branches branches;
    bool complete = !conditional.otherwise.empty();
    for (const If::Branch& branch : conditional.branches) {
      const bool* const value =
          branch.condition ? std::get_if<bool>(&branch.condition->constant) : nullptr;
      if (value != nullptr && !*value) continue;
      branches.add(branch.body);
      if (value == nullptr) continue;
      return branches.result(true);
    }
    if (complete) branches.add(conditional.otherwise);
    return branches.result(complete);
  }
  Ending operator()(const With& with) const { return ending_of(with.body); }
  Ending operator()(const Press& press) const { return ending_of(press.body); }
  Ending operator()(const Select& select) const {
    Branches branches;
    for (const Select::Case& one : select.cases) branches.add(one.body);
    if (select.has_else) branches.add(select.otherwise);
    return branches.result(select.has_else);
  }
  Ending operator()(const Wait& wait) const { return behind_else(wait.otherwise); }
  Ending operator()(const WatchedMotion& watched) const { return behind_else(watched.otherwise); }
  Ending operator()(const Loop& loop) const {
    if (!has_exit(loop.body)) return Ending::Never;
    return has_return(loop.body) ? Ending::Maybe : Ending::Surely;
  }
  Ending operator()(const While& loop) const {
    const bool* const value =
        loop.condition ? std::get_if<bool>(&loop.condition->constant) : nullptr;
    if (value != nullptr && *value && !has_exit(loop.body)) return Ending::Never;
    return has_return(loop.body) ? Ending::Maybe : Ending::Surely;
  }
  Ending operator()(const For& loop) const {
    return has_return(loop.body) ? Ending::Maybe : Ending::Surely;
  }
  template <typename Other>
  Ending operator()(const Other&) const {
    return Ending::Surely;
  }
};

}  // namespace

Ending ending_of(const Block& block) {
  Ending ending = Ending::Surely;
  for (const Statement& statement : block) {
    const Ending next = std::visit(EndingOf{}, statement.node);
    if (next == Ending::Never) return Ending::Never;
    ending = std::min(ending, next);
  }
  return ending;
}

}  // namespace rob::lang
