#include "lang/check/return_paths.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

namespace rob::lang {
namespace {

/// The last thing on a way out of a block.
struct WayOut {
  enum class By : std::uint8_t { Statement, EmptyBlock, MissingElse, EndOfLoop, Exit };
  By by = By::Statement;
  std::string_view word;  ///< of MissingElse and EndOfLoop
  std::uint32_t line = 0;
};

std::string in_words(const WayOut& way) {
  switch (way.by) {
    case WayOut::By::Statement:
      return fmt::format("nothing returns after line {}", way.line);
    case WayOut::By::EmptyBlock:
      return way.line == 0 ? "it has no statement"
                           : fmt::format("a block of line {} is empty", way.line);
    case WayOut::By::MissingElse:
      return fmt::format("the {} in line {} has no ELSE", way.word, way.line);
    case WayOut::By::EndOfLoop:
      return fmt::format("the {} in line {} can end", way.word, way.line);
    case WayOut::By::Exit:
      return fmt::format("the EXIT in line {} leaves the loop", way.line);
  }
  return "";
}

/// The ways on from a statement or a block, other than RETURN, RAISE and going on for ever.
struct Ways {
  std::optional<WayOut> end{};   ///< to what follows it
  std::optional<WayOut> exit{};  ///< to what follows the loop around it
  bool next = false;             ///< to the next turn of that loop

  /// Where one or the other happens.
  void join(const Ways& other) {
    if (!end) end = other.end;
    if (!exit) exit = other.exit;
    next = next || other.next;
  }
};

const bool* constant_truth(const ExprPtr& condition) {
  return condition == nullptr ? nullptr : std::get_if<bool>(&condition->constant);
}

/// A condition that is wrong and reported: nothing is said about where it leads.
bool is_faulty(const ExprPtr& condition) {
  return condition == nullptr || !condition->type.known();
}

Ways ways_of(const Block& block, std::uint32_t line);

/// Of a statement that begins in `line`.
struct WaysOf {
  std::uint32_t line;

  Ways on() const { return {.end = WayOut{WayOut::By::Statement, {}, line}}; }
  Ways block(const Block& block) const { return ways_of(block, line); }
  WayOut without_else(std::string_view word) const { return {WayOut::By::MissingElse, word, line}; }

  Ways operator()(const Return&) const { return {}; }
  Ways operator()(const Raise&) const { return {}; }
  Ways operator()(const Exit&) const { return {.exit = WayOut{WayOut::By::Exit, {}, line}}; }
  Ways operator()(const Next&) const { return {.next = true}; }
  Ways operator()(const Assert& assertion) const {
    const bool* const holds = constant_truth(assertion.condition);
    return holds != nullptr && !*holds ? Ways{} : on();
  }
  Ways operator()(const If& conditional) const {
    Ways ways;
    for (const If::Branch& branch : conditional.branches) {
      const bool* const holds = constant_truth(branch.condition);
      if (holds != nullptr && !*holds) continue;
      ways.join(block(branch.body));
      if (holds != nullptr) return ways;
    }
    if (!conditional.has_else) {
      ways.join({.end = without_else("IF")});
    } else {
      ways.join(block(conditional.otherwise));
    }
    return ways;
  }
  Ways operator()(const Select& select) const {
    Ways ways;
    bool complete = select.has_else;
    for (const Select::Case& one : select.cases) ways.join(ways_of(one.body, one.place.line));
    if (select.has_else) ways.join(block(select.otherwise));
    if (!complete && !is_faulty(select.selector)) complete = takes_both_truths(select);
    if (!complete) ways.join({.end = without_else("SELECT")});
    return ways;
  }
  /// TRUE and FALSE are all that there is. A value stands in one CASE only.
  static bool takes_both_truths(const Select& select) {
    if (!select.selector->type.is(Type::Kind::Bool)) return false;
    std::ptrdiff_t truths = 0;
    for (const Select::Case& one : select.cases)
      truths += std::ranges::count_if(one.values, constant_truth);
    return truths == 2;
  }
  Ways operator()(const Try& guarded) const {
    Ways ways = block(guarded.body);
    ways.join(block(guarded.rescue));
    return ways;
  }
  Ways operator()(const With& with) const { return block(with.body); }
  Ways operator()(const Press& press) const { return block(press.body); }
  /// ELSE is taken where something did not happen in time.
  Ways operator()(const Wait& wait) const { return on_or_else(wait.otherwise); }
  Ways operator()(const WatchedMotion& watched) const { return on_or_else(watched.otherwise); }
  Ways on_or_else(const Block& otherwise) const {
    Ways ways = on();
    ways.join(block(otherwise));
    return ways;
  }
  Ways operator()(const Loop& loop) const { return {.end = block(loop.body).exit}; }
  Ways operator()(const While& loop) const {
    const bool* const holds = constant_truth(loop.condition);
    if (is_faulty(loop.condition) || (holds != nullptr && *holds)) {
      return {.end = block(loop.body).exit};
    }
    return {.end = WayOut{WayOut::By::EndOfLoop, "WHILE", line}};
  }
  Ways operator()(const For& loop) const {
    const Ways turn = block(loop.body);
    if (loop.turns && !turn.end && !turn.next) return {.end = turn.exit};
    return {.end = WayOut{WayOut::By::EndOfLoop, "FOR", line}};
  }
  template <typename Other>
  Ways operator()(const Other&) const {
    return on();
  }
};

/// `line`: that of the statement which the block belongs to; 0 for the body of a routine.
Ways ways_of(const Block& block, std::uint32_t line) {
  Ways ways{.end = WayOut{WayOut::By::EmptyBlock, {}, line}};
  for (const Statement& statement : block) {
    ways.end.reset();
    ways.join(std::visit(WaysOf{statement.place.line}, statement.node));
    if (!ways.end) break;  // what stands behind is never reached
  }
  return ways;
}

}  // namespace

std::optional<std::string> way_without_return(const Block& body) {
  const Ways ways = ways_of(body, 0);
  return ways.end ? std::optional(in_words(*ways.end)) : std::nullopt;
}

}  // namespace rob::lang
