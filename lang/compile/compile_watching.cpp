#include <algorithm>
#include <utility>
#include <vector>

#include "lang/check/fold.h"
#include "lang/check/observations.h"
#include "lang/check/target.h"
#include "lang/compile/expression_compiler.h"
#include "lang/compile/statement_compiler.h"

/// Code for what is evaluated in every control cycle, and for the statements that it belongs to.
namespace rob::lang {
namespace {

/// What is fixed when the statement is executed: variables, each once, and the elements and fields
/// of arrays and records, whose index may be computed.
class Fixed {
 public:
  void gather(const Expr& expression) {
    if (known(expression.constant)) return;
    if (const auto* const name = std::get_if<Name>(&expression.node)) {
      const bool first = std::ranges::none_of(parts_, [&](const Expr* other) {
        const auto* const known_one = std::get_if<Name>(&other->node);
        return known_one != nullptr && known_one->symbol == name->symbol;
      });
      if (first && is_fixed(*name->symbol)) parts_.push_back(&expression);
    } else if (is_part_of_variable(expression)) {
      parts_.push_back(&expression);
    } else if (const auto* const unary = std::get_if<Unary>(&expression.node)) {
      gather(*unary->operand);
    } else if (const auto* const binary = std::get_if<Binary>(&expression.node)) {
      gather(*binary->left);
      gather(*binary->right);
    } else if (const auto* const call = std::get_if<Call>(&expression.node)) {
      for (const ExprPtr& argument : call->arguments) gather(*argument);
    } else if (const auto* const tuple = std::get_if<Tuple>(&expression.node)) {
      for (const Tuple::Element& element : tuple->elements) gather(*element.value);
    } else if (const auto* const member = std::get_if<Member>(&expression.node)) {
      gather(*member->object);
    } else if (const auto* const index = std::get_if<Index>(&expression.node)) {
      gather(*index->object);
    }
  }
  const std::vector<const Expr*>& parts() const { return parts_; }

 private:
  static bool is_fixed(const Symbol& symbol) { return !is_read(symbol) && !known(symbol.value); }
  static bool is_read(const Symbol& symbol) {
    return symbol.kind == Symbol::Kind::Signal ||
           (symbol.kind == Symbol::Kind::Reading && is_observation(symbol.reading));
  }
  static bool is_part_of_variable(const Expr& expression) {
    if (const auto* const member = std::get_if<Member>(&expression.node)) {
      if (!member->object->type.is(Type::Kind::Record)) return false;
    } else if (!std::holds_alternative<Index>(expression.node)) {
      return false;
    }
    const Name* const root = root_of(expression);
    return root != nullptr && !is_read(*root->symbol);
  }

  std::vector<const Expr*> parts_;
};

}  // namespace

/// Their values lie side by side, in the watch as in the frame that sets it up.
ExpressionCompiler::WatchCode ExpressionCompiler::watch(const Expr& condition) {
  Fixed fixed;
  fixed.gather(condition);
  const Place place = condition.place;
  latched_ = false;
  refresh(observed_globals(condition), place);
  int count = 0;
  for (const Expr* const part : fixed.parts()) count += slots_of(part->type).numbers;
  const Register values = code_.number_registers(std::max(count, 1));
  Register next = values;
  for (const Expr* const part : fixed.parts()) {
    into_as_it_is(*part, next, false);
    next = static_cast<Register>(next + slots_of(part->type).numbers);
  }
  code_.begin_watch(place);
  std::vector<std::pair<const Symbol*, Location>> homes;
  for (const Expr* const part : fixed.parts()) {
    const Register first = code_.number_registers(slots_of(part->type).numbers);
    const Location own{{SlotsAt::Base::Own, first}, {}};
    if (const auto* const name = std::get_if<Name>(&part->node)) {
      homes.emplace_back(name->symbol, homes_[name->symbol->id]);
      settle(*name->symbol, own);
    } else {
      fixed_parts_.emplace_back(part, own);
    }
  }
  latched_ = false;
  watching_ = true;
  const Register answer = operand(condition, false);
  watching_ = false;
  fixed_parts_.clear();
  for (const auto& [symbol, location] : homes) settle(*symbol, location);
  return {code_.end_watch(answer, count, place), values};
}

void StatementCompiler::compile(const When& when) {
  const Place place = place_;
  const Routine* const handler = when.handled ? &program_.routines[when.handler] : nullptr;
  const Register captured = handler != nullptr ? capture(*handler) : Register{0};
  const auto mark = code_.mark();
  const ExpressionCompiler::WatchCode watch = expressions_.watch(*when.condition);
  code_.when(watch.values, watch.index, whens_++, place);
  if (handler != nullptr) {
    code_.when_handle(captured, captures_of(*handler), handler->stops, handler->index, place);
  } else if (const auto* const raise = std::get_if<Raise>(&when.action.front().node)) {
    code_.emit(Opcode::when_raise, when.action.front().place, expressions_.value(*raise->value));
  } else {
    compile(when.action);
  }
  code_.release(mark);
}

void StatementCompiler::leave_whens(std::size_t kept) {
  if (whens_ == kept) return;
  code_.emit(Instruction::ax(Opcode::disarm, 0, static_cast<std::uint16_t>(kept)), place_);
}

/// AT LIVE: set up before the motion that it belongs to.
void StatementCompiler::compile_live(const Expr& pace) {
  const auto mark = code_.mark();
  const ExpressionCompiler::WatchCode watch = expressions_.watch(pace);
  code_.emit(Instruction::ax(Opcode::live_pace, watch.values, watch.index), pace.place);
  code_.emit(Instruction{static_cast<std::uint32_t>(*pace_of(pace.type))}, pace.place);
  code_.release(mark);
}

void StatementCompiler::compile(const WayPoint& event) {
  const auto mark = code_.mark();
  const Register distance = code_.number_registers(2);
  const auto lead = static_cast<Register>(distance + 1);
  expressions_.value_into(*event.distance, distance);
  if (event.shift == nullptr) {
    code_.load_real(lead, 0, kTime, event.place);
  } else {
    expressions_.value_into(*event.shift, lead);
    if (event.lag) code_.emit(Opcode::neg_real, event.place, lead, lead);
  }
  code_.emit(Opcode::on_the_way, event.place, distance, event.before ? 1 : 0);
  compile(event.action);
  code_.release(mark);
}

/// The guard is set before the motion is commanded, and asked for behind it.
void StatementCompiler::compile(const WatchedMotion& watched) {
  const Place place = place_;
  const auto mark = code_.mark();
  const auto& move = std::get<Move>(watched.motion.front().node);
  enter(move.clauses.surroundings);
  for (const WayPoint& event : watched.events) compile(event);
  place_ = place;  // the actions of the events have theirs
  if (watched.until == nullptr) {
    compile_motion(move);
    return leave(move.clauses.surroundings, place);
  }
  const ExpressionCompiler::WatchCode watch = expressions_.watch(*watched.until);
  code_.emit(Instruction::ax(Opcode::guard, watch.values, watch.index), place);
  compile_motion(move);
  const Register hit = code_.number_registers();
  code_.emit(Opcode::ended, place, hit);
  leave(move.clauses.surroundings, place);
  if (watched.has_else) {
    code_.emit(Opcode::if_bool, place, hit, 1);
    const CodeBuilder::Jump done = code_.jump(place);
    compile(watched.otherwise);
    code_.land(done);
  }
  code_.release(mark);
}

}  // namespace rob::lang
