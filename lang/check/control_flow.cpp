#include "lang/check/control_flow.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "lang/check/meaning.h"
#include "lang/check/symbols.h"
#include "lang/text/codes.h"

namespace rob::lang {

// The ways to the end of a FUNC

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

/// The ways on from a statement that begins in `line`.
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
    if (!complete && !is_faulty(select.selector)) {
      complete = takes_both_truths(select) || takes_all_names(select);
    }
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
  /// The same of an ENUM.
  static bool takes_all_names(const Select& select) {
    const Type& type = select.selector->type;
    if (!type.is(Type::Kind::Enum)) return false;
    std::ptrdiff_t names = 0;
    for (const Select::Case& one : select.cases) {
      names += std::ranges::count_if(one.values, [](const ExprPtr& value) {
        return value != nullptr && std::holds_alternative<std::int64_t>(value->constant);
      });
    }
    return names == std::ssize(type.detail->names);
  }
  Ways operator()(const Try& guarded) const {
    Ways ways = block(guarded.body);
    ways.join(block(guarded.rescue));
    return ways;
  }
  Ways operator()(const With& with) const { return block(with.body); }
  Ways operator()(const Press& press) const { return block(press.body); }
  Ways operator()(const Allow& allow) const { return block(allow.body); }
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
    if (!ways.end) break;  // the statements after it are never reached
  }
  return ways;
}

}  // namespace

std::optional<std::string> way_without_return(const Block& body) {
  const Ways ways = ways_of(body, 0);
  return ways.end ? std::optional(in_words(*ways.end)) : std::nullopt;
}

// Readings in corners

namespace {

/// Whether it shows how far a motion has come.
bool tells_progress(Reading reading) {
  return reading == Reading::Here || reading == Reading::Clock || reading == Reading::Joints;
}

/// Whether an expression is by itself HERE, CLOCK or JOINTS().
bool is_progress(const Expr& expression) {
  if (const auto* const name = std::get_if<Name>(&expression.node)) {
    const Symbol* const symbol = name->symbol;
    return symbol != nullptr && symbol->kind == Symbol::Kind::Reading &&
           tells_progress(symbol->reading);
  }
  const auto* const call = std::get_if<Call>(&expression.node);
  const auto reading = call != nullptr ? reading_of(*call) : std::nullopt;
  return reading && tells_progress(*reading) && expression.type.known();
}

/// The first of them in an expression; null if there is none.
const Expr* reading_in(const Expr& expression) {
  if (is_progress(expression)) return &expression;
  const Expr* found = nullptr;
  each_part(expression, [&](const Expr& part) {
    if (found == nullptr) found = reading_in(part);
  });
  return found;
}

/// Goes through statements in their order and keeps which motion, not exact, came last.
class Walk {
 public:
  explicit Walk(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void block(const Block& block) {
    for (const Statement& statement : block) {
      place_ = statement.place;
      std::visit([&](const auto& node) { visit(node); }, statement.node);
    }
  }

 private:
  void visit(const Move& move) {
    for (const ExprPtr& point : move.via) look(point);
    look(move.target);
    look(move.clauses.near);
    for (const ExprPtr& value : move.clauses.values)  // AT LIVE is read while it moves
      if (!move.clauses.live || &value != &move.clauses[Clause::At]) look(value);
    const ExprPtr& zone = move.clauses[Clause::Zone];
    const bool own = move.clauses.fine || zone != nullptr;
    const bool exact = move.clauses.at_rest() || (own ? exact_zone(zone) : exact_default_);
    settle(exact || move.kind == MotionKind::Jog ? 0 : place_.line);  // a jog has no corner
  }
  void visit(const PlainMotions& motions) {
    settle(exact_default_ ? 0 : motions.motions.back().line);
  }
  void visit(const WatchedMotion& watched) {
    block(watched.motion);
    if (watched.until != nullptr) settle(0);
    block(watched.otherwise);
  }
  void visit(const With& with) {
    const bool around = exact_default_;
    visit_defaults(with.clauses);
    block(with.body);
    exact_default_ = around;
  }
  void visit(const Defaults& defaults) { visit_defaults(defaults.clauses); }
  void visit_defaults(const Clauses& clauses) {
    for (const ExprPtr& value : clauses.values) look(value);
    const ExprPtr& zone = clauses[Clause::Zone];
    if (clauses.fine || zone != nullptr) exact_default_ = clauses.fine || exact_zone(zone);
  }
  static bool exact_zone(const ExprPtr& zone) {
    return zone != nullptr && constant_number(*zone) == 0.0;
  }
  void visit(const PathBlock& path) { block(path.body); }
  void visit(const Allow& allow) { block(allow.body); }
  void visit(const Press& press) {
    look(press.force);
    settle(0);  // it begins at standstill, and ends there
    block(press.body);
    settle(0);
  }
  void visit(const Stop&) { settle(0); }
  void visit(const Brake&) { settle(0); }
  void visit(const Teach&) { settle(0); }
  void visit(const Halt&) { settle(0); }
  void visit(const Ask&) { settle(0); }
  void visit(const Read&) { settle(0); }
  void visit(const Wait& wait) {
    settle(0);
    block(wait.otherwise);
  }
  void visit(const Declaration& declaration) { look(declaration.value); }
  void visit(const Assign& assign) { look(assign.value); }
  void visit(const Print& print) {
    for (const ExprPtr& value : print.values) look(value);
  }
  void visit(const Send& send) {
    for (const ExprPtr& value : send.values) look(value);
  }
  void visit(const Receive& receive) {
    settle(0);
    block(receive.otherwise);
  }
  void visit(const Write& write) {
    for (const ExprPtr& value : write.values) look(value);
  }
  void visit(const Assert& assertion) { look(assertion.condition); }
  void visit(const Expect& expectation) { look(expectation.condition); }
  void visit(const CallStatement& statement) { look(statement.call); }
  void visit(const Return& statement) { look(statement.value); }
  void visit(const If& conditional) {
    perhaps([&] {
      for (const If::Branch& branch : conditional.branches) {
        look(branch.condition);
        inner(branch.body);
      }
      inner(conditional.otherwise);
    });
  }
  void visit(const Select& select) {
    look(select.selector);
    perhaps([&] {
      for (const Select::Case& one : select.cases) inner(one.body);
      inner(select.otherwise);
    });
  }
  void visit(const While& loop) {
    look(loop.condition);
    perhaps([&] { inner(loop.body); });
  }
  void visit(const For& loop) {
    for (const ExprPtr* value : {&loop.elements, &loop.from, &loop.to, &loop.step}) look(*value);
    perhaps([&] { inner(loop.body); });
  }
  void visit(const Loop& loop) {
    perhaps([&] { inner(loop.body); });
  }
  void visit(const Try& statement) {
    inner(statement.body);
    settle(0);  // RESCUE waits until the axes stand; whether it comes is not known
    block(statement.rescue);
    settle(0);
  }
  void visit(const auto& /*moves nothing and reads nothing*/) {}

  /// Blocks that are perhaps executed: after them, the motion before them is the last one only if
  /// there is none in them.
  template <typename Visit>
  void perhaps(Visit visit_blocks) {
    const std::uint32_t before = settled_;
    visit_blocks();
    if (settled_ != before) loose_ = 0;
  }
  void inner(const Block& body) {
    const std::uint32_t before = loose_;
    block(body);
    loose_ = before;
  }
  void settle(std::uint32_t line) {
    loose_ = line;
    ++settled_;
  }

  void look(const ExprPtr& expression) {
    const Expr* const reading =
        loose_ == 0 || expression == nullptr ? nullptr : reading_in(*expression);
    if (reading != nullptr) {
      const auto* const symbol = std::get_if<Name>(&reading->node);
      const std::string name = symbol != nullptr ? symbol->symbol->name : "JOINTS()";
      diagnostics_.warning(
          code::kReadInCorner, reading->place,
          fmt::format("{} is read where the corner of line {} begins, before its target is reached",
                      name, loose_),
          "FINE at that motion, or STOP after it, makes it exact");
    }
    if (expression != nullptr && calls_routine(*expression)) settle(0);
  }

  Diagnostics& diagnostics_;
  Place place_;
  std::uint32_t loose_ = 0;     ///< line of the last motion, where it is not exact; 0: none
  std::uint32_t settled_ = 0;   ///< how often that was settled
  bool exact_default_ = false;  ///< a DEFAULT or WITH makes motions exact that say nothing
};

}  // namespace

void warn_of_corner_readings(const Program& program, Diagnostics& diagnostics) {
  Walk(diagnostics).block(program.statements);
  for (const Routine& routine : program.routines) Walk(diagnostics).block(routine.body);
}

}  // namespace rob::lang
