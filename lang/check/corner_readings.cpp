#include "lang/check/corner_readings.h"

#include <string>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/check/observations.h"
#include "lang/check/routine.h"
#include "lang/check/symbols.h"
#include "lang/check/target.h"
#include "lang/text/codes.h"

namespace rob::lang {
namespace {

/// Whether it tells how far a motion has come.
bool tells_progress(Reading reading) {
  return reading == Reading::Here || reading == Reading::Clock || reading == Reading::Joints;
}

/// The first HERE, CLOCK or JOINTS() in an expression; null if there is none.
const Expr* reading_in(const ExprPtr& expression);

struct ReadingFinder {
  const Expr& whole;

  const Expr* operator()(const Name& name) const {
    const Symbol* const symbol = name.symbol;
    const bool reading = symbol != nullptr && symbol->kind == Symbol::Kind::Reading &&
                         tells_progress(symbol->reading);
    return reading ? &whole : nullptr;
  }
  const Expr* operator()(const Unary& unary) const { return reading_in(unary.operand); }
  const Expr* operator()(const Binary& binary) const {
    const Expr* const left = reading_in(binary.left);
    return left != nullptr ? left : reading_in(binary.right);
  }
  const Expr* operator()(const Call& call) const {
    const auto reading = reading_of(call);
    if (reading && tells_progress(*reading) && whole.type.known()) return &whole;
    for (const ExprPtr& argument : call.arguments) {
      if (const Expr* const found = reading_in(argument)) return found;
    }
    return nullptr;
  }
  const Expr* operator()(const Tuple& tuple) const {
    for (const Tuple::Element& element : tuple.elements) {
      if (const Expr* const found = reading_in(element.value)) return found;
    }
    return nullptr;
  }
  const Expr* operator()(const List& list) const {
    for (const ExprPtr& element : list.elements) {
      if (const Expr* const found = reading_in(element)) return found;
    }
    return nullptr;
  }
  const Expr* operator()(const Member& member) const { return reading_in(member.object); }
  const Expr* operator()(const Index& index) const {
    const Expr* const object = reading_in(index.object);
    return object != nullptr ? object : reading_in(index.index);
  }
  const Expr* operator()(const auto& /*literal*/) const { return nullptr; }
};

const Expr* reading_in(const ExprPtr& expression) {
  if (expression == nullptr) return nullptr;
  return std::visit(ReadingFinder{*expression}, expression->node);
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
    for (const ExprPtr& value : move.clauses.values)  // AT LIVE is read while it moves
      if (!move.clauses.live || &value != &move.clauses[Clause::At]) look(value);
    const ExprPtr& zone = move.clauses[Clause::Zone];
    const bool exact = move.clauses.at_rest() || (zone != nullptr && constant_number(*zone) == 0.0);
    settle(exact || move.kind == MotionKind::Jog ? 0 : place_.line);  // a jog has no corner
  }
  void visit(const PlainMotions& motions) { settle(motions.motions.back().line); }
  void visit(const WatchedMotion& watched) {
    block(watched.motion);
    if (watched.until != nullptr) settle(0);
    block(watched.otherwise);
  }
  void visit(const With& with) { block(with.body); }
  void visit(const PathBlock& path) { block(path.body); }
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
  void visit(const Wait& wait) {
    settle(0);
    block(wait.otherwise);
  }
  void visit(const Declaration& declaration) { look(declaration.value); }
  void visit(const Assign& assign) { look(assign.value); }
  void visit(const Print& print) {
    for (const ExprPtr& value : print.values) look(value);
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
    for (const ExprPtr* value : {&loop.from, &loop.to, &loop.step}) look(*value);
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

  /// Blocks that are perhaps executed: behind them, the motion before them is the last one only if
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
    const Expr* const reading = loose_ == 0 ? nullptr : reading_in(expression);
    if (reading != nullptr) {
      const auto* const symbol = std::get_if<Name>(&reading->node);
      const std::string name = symbol != nullptr ? symbol->symbol->name : "JOINTS()";
      diagnostics_.warning(
          code::kReadInCorner, reading->place,
          fmt::format("{} is read where the corner of line {} begins, before its target is reached",
                      name, loose_),
          "FINE at that motion, or STOP behind it, makes it exact");
    }
    if (expression != nullptr && calls_routine(*expression)) settle(0);
  }

  Diagnostics& diagnostics_;
  Place place_;
  std::uint32_t loose_ = 0;    ///< line of the last motion, where it is not exact; 0: none
  std::uint32_t settled_ = 0;  ///< how often that was settled
};

}  // namespace

void warn_of_corner_readings(const Program& program, Diagnostics& diagnostics) {
  Walk(diagnostics).block(program.statements);
  for (const Routine& routine : program.routines) Walk(diagnostics).block(routine.body);
}

}  // namespace rob::lang
