#include "lang/check/statement_checker.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "lang/check/control_flow.h"
#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/values/number_text.h"
#include "lang/values/setting.h"

namespace rob::lang {
namespace {

bool is_constant(const ExprPtr& condition, bool value) {
  if (condition == nullptr) return false;
  const bool* const constant = std::get_if<bool>(&condition->constant);
  return constant != nullptr && *constant == value;
}

/// Without ELSE, the SELECT of an ENUM does nothing for the names that it leaves out.
void warn_of_missing_cases(const Select& select, const std::map<Constant, std::uint32_t>& lines,
                           Diagnostics& diagnostics) {
  const bool all_known = std::ranges::all_of(select.cases, [](const Select::Case& one) {
    return std::ranges::all_of(one.values, [](const ExprPtr& value) {
      return value != nullptr && known(value->constant);
    });
  });
  if (select.has_else || !all_known) return;
  const TypeDetail& detail = *select.selector->type.detail;
  std::vector<bool> named(detail.names.size());
  for (const auto& [value, line] : lines) {
    const auto* const number = std::get_if<std::int64_t>(&value);
    if (number != nullptr) named.at(static_cast<std::size_t>(*number)) = true;
  }
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < named.size(); ++i) {
    if (!named[i]) missing.push_back(enum_text(detail, static_cast<std::int64_t>(i)));
  }
  if (missing.empty()) return;
  diagnostics.warning(code::kCaseMissing, select.selector->place,
                      fmt::format("this SELECT leaves out {}", fmt::join(missing, ", ")),
                      "a CASE for it, or ELSE, says what is done then");
}

/// The type of an element that FOR x IN goes through; it has been checked.
Type check_elements(For& loop, ValueChecker& values, Diagnostics& diagnostics) {
  if (loop.elements == nullptr) return {};
  const Type type = loop.elements->type;
  if (!type.known()) return {};
  if (values.refuse_empty(*loop.elements)) return {};
  if (!type.has_row()) {
    diagnostics.error(
        code::kNoElements, loop.elements->place,
        fmt::format("FOR IN goes through the elements of an ARRAY or LIST; this is {}",
                    described(*loop.elements)),
        type.numeric() ? fmt::format("FOR {} = 1 TO n DO counts", shortened(loop.variable)) : "");
    return {};
  }
  loop.turns = type.detail->length > 0;
  return type.detail->element;
}

/// Where a line could not be read it may have been the RETURN.
void check_returns(const Routine& routine, Diagnostics& diagnostics) {
  if (!routine.whole) return;
  const auto way = way_without_return(routine.body);
  if (!way) return;
  diagnostics.error(code::kReturnMissing, routine.end,
                    fmt::format("{} can end without RETURN: {}", shortened(routine.name), *way),
                    "RETURN a value there, or RAISE an error if this cannot happen");
}

}  // namespace

StatementChecker::StatementChecker(CheckedProgram& checked, Scopes& scopes,
                                   Declarations& declarations, Names& names,
                                   ExpressionChecker& expressions, ValueChecker& values,
                                   MissingPoints& missing, RoutineUses& uses,
                                   const RobotSignature& robot, const PointTable& points,
                                   const TargetJudge& judge, Diagnostics& diagnostics)
    : scopes_(scopes),
      declarations_(declarations),
      names_(names),
      expressions_(expressions),
      values_(values),
      uses_(uses),
      diagnostics_(diagnostics),
      features_(checked.features),
      routines_(checked.program.routines),
      moves_(robot, names, expressions, values, judge, diagnostics, checked),
      outlets_(names, expressions, values, uses, diagnostics),
      paths_(diagnostics),
      clauses_(expressions, values, diagnostics),
      watches_(expressions, values, diagnostics),
      waits_(expressions, values, diagnostics),
      signals_(scopes, declarations, names, expressions, values, diagnostics),
      shapes_(expressions, values, robot, checked.program, diagnostics),
      declared_(scopes, declarations, names, expressions, values, missing, shapes_, points,
                checked.program, diagnostics) {}

void StatementChecker::know(const KeptName& kept, const Symbol& symbol) {
  signals_.know(kept, symbol);
  declared_.know(symbol);
}

void StatementChecker::report_waits_and_paths() {
  waits_.report_hopeless(uses_);
  paths_.report_reads();
}

void StatementChecker::check(Statement& statement) {
  place_ = statement.place;
  uses_.statement(statement);
  std::visit([&](auto& node) { check(node); }, statement.node);
  paths_.check(statement);
}

void StatementChecker::check(Block& block) {
  const Declarations::OpenScope scope(declarations_);
  for (Statement& statement : block) check(statement);
  moves_.warn_of_zones(block);
}

void StatementChecker::check_guarded(Block& block, bool unreached) {
  if (unreached) values_.enter_unreached();
  check(block);
  if (unreached) values_.leave_unreached();
}

// Motions

void StatementChecker::check(WatchedMotion& watched) {
  const auto& move = std::get<Move>(watched.motion.front().node);
  moves_.check(move, place_, watched.until != nullptr);
  if (watched.until == nullptr && watched.events.empty()) {
    diagnostics_.warning(code::kNoEvents, place_, "nothing is done on the way of this motion",
                         "leave DO and ENDMOVE out, or write AFTER 5mm : lift = ON between them");
  }
  if (move.kind == MotionKind::Jog && !watched.events.empty()) {
    diagnostics_.error(code::kClauseMisplaced, watched.events.front().place,
                       "a JOG has no length on which a place could lie",
                       "set or pulse it before or after the JOG");
  }
  if (watched.until != nullptr) watches_.check_until(watched.until);
  check(watched.otherwise);
  for (WayPoint& event : watched.events) {
    check(event.action);
    watches_.check_event(event);
  }
}

void StatementChecker::check(WayPoint& event) {
  const bool path = paths_.enter(false);  // the action is done on the way
  check(event.action);
  paths_.enter(path);
  watches_.check_event(event);
  paths_.note(event);
}

void StatementChecker::check(With& with) {
  clauses_.check_defaults(with.clauses, "WITH", place_);
  remember_accel(with.clauses);
  const bool elsewhere = !with.clauses.surroundings.none();
  if (elsewhere) moves_.enter_surroundings();
  check(with.body);
  if (elsewhere) moves_.leave_surroundings();
}

void StatementChecker::check(Defaults& defaults) {
  if (default_line_ != 0) {
    diagnostics_.error(code::kDefaultTwice, place_,
                       fmt::format("there is a DEFAULT already, in line {}", default_line_),
                       "write all clauses after that one");
  }
  default_line_ = place_.line;
  clauses_.check_defaults(defaults.clauses, "DEFAULT", place_);
  remember_accel(defaults.clauses);
}

void StatementChecker::remember_accel(const Clauses& clauses) {
  const ExprPtr& accel = clauses[Clause::Accel];
  if (accel != nullptr) features_.push_back({accel->place, MotionFeature::Accel});
}

void StatementChecker::check(PathBlock& path) {
  const Place place = place_;
  features_.push_back({place, MotionFeature::Path});
  clauses_.check(path.clauses, place);
  if (path.clauses.live) watches_.check_live(*path.clauses[Clause::At]);
  paths_.check_clauses(path.clauses, place);
  const bool outer = paths_.enter(true);  // the PATH around it reports that
  const int loops = std::exchange(inside_.loops, 0);
  moves_.enter_surroundings();
  const bool in_path = uses_.in_path(true);
  check(path.body);
  uses_.in_path(in_path);
  moves_.leave_surroundings();
  inside_.loops = loops;
  paths_.enter(outer);
  paths_.warn_of_empty(path, place);
}

void StatementChecker::check(Press& press) {
  const Place place = place_;
  features_.push_back({place, MotionFeature::Press});
  if (pressing_) {
    diagnostics_.error(code::kPressInPress, place,
                       "a PRESS cannot stand inside another: it begins at standstill",
                       "close the first with ENDPRESS");
  }
  expressions_.check_as(press.force, Type::real(kForce), "PRESS needs");
  if (expressions_.check_as(press.limit, Type::real(kSpeed), "LIMIT needs")) {
    values_.require_positive(*press.limit, "LIMIT");
  }
  clauses_.check(press.surroundings);
  const bool outer = std::exchange(pressing_, true);
  check(press.body);
  pressing_ = outer;
}

void StatementChecker::check(Allow& allow) {
  shapes_.check_names(allow);
  check(allow.body);
}

void StatementChecker::check(Load& load) {
  expressions_.check(load.mass);
  const bool mass = values_.accept(*load.mass, Type::real(kMass), "LOAD needs");
  if (load.cog != nullptr) {
    expressions_.check(load.cog);
    values_.accept(*load.cog, Type::vec(kLength), "COG needs");
  }
  const auto number = constant_number(*load.mass);
  if (!mass || !number || (*number >= 0 && *number <= kMostLoad)) return;
  diagnostics_.error(code::kLoadBeyond, load.mass->place,
                     fmt::format("LOAD is 0kg or more and at most {}; this is {}",
                                 number_text(kMostLoad, kMass), number_text(*number, kMass)),
                     "LOAD 0kg lets go");
}

// Names and values

void StatementChecker::check(Teach& teach) {
  declared_.check(teach, inside_.routine == nullptr && scopes_.at_top_level());
}

/// Where a file is USEd for the first time its declarations are checked, with its own names.
void StatementChecker::check(Use& use) {
  if (use.file == 0) return;
  const Place place = place_;
  const std::uint32_t user = scopes_.enter_file(use.file);
  for (Statement& statement : use.declarations) {
    uses_.next_statement();
    check(statement);
  }
  scopes_.enter_file(user);
  for (const Symbol* const own : scopes_.shared_with(use.file)) {
    declarations_.warn_of_hiding(own->name, own->place, use.name);
  }
  scopes_.use(use.name, use.file);
  place_ = place;
}

void StatementChecker::check(Assign& assign) {
  expressions_.check(assign.value);
  expressions_.check(assign.target);
  const Name* const root = root_of(*assign.target);
  if (root == nullptr) {
    diagnostics_.error(code::kNotAssignable, assign.target->place,
                       "only a variable, or a part of one, can be assigned");
    return;
  }
  if (const auto* const member = std::get_if<Member>(&assign.target->node);
      member != nullptr && angle_of(member->object->type, member->field)) {
    diagnostics_.error(code::kAngleAssigned, assign.target->place,
                       "an angle of a pose cannot be changed alone",
                       "build the pose anew: POSE(p.x, p.y, p.z, a, b, c)");
    return;
  }
  if (root->symbol == nullptr || !assignable(*root->symbol, assign.target->place, diagnostics_))
    return;
  if (assign.compound && root->symbol->kind != Symbol::Kind::Variable) {
    diagnostics_.error(code::kNotAssignable, assign.target->place,
                       fmt::format("{} is no variable: only one can be changed by what it is",
                                   shortened(root->symbol->name)),
                       "write the whole value after '='");
    return;
  }
  uses_.written(*root->symbol, assign.target->place);
  if (assign.value == nullptr || values_.refuse_open(*assign.target)) return;
  values_.accept(*assign.value, assign.target->type,
                 fmt::format("{} needs", shortened(root->symbol->name)));
}

void StatementChecker::check(Print& print) {
  for (const ExprPtr& value : print.values) expressions_.check(value);
}

// HALT, ASK, and TESTs

void StatementChecker::check(Ask& ask) {
  expressions_.check_as(ask.text, Type::string(), "ASK needs");
  const Type type = expressions_.check(ask.target);
  if (ask.target == nullptr) return;
  const Name* const root = root_of(*ask.target);
  if (root != nullptr && root->symbol == nullptr) return;
  const auto refuse = [&](std::string message) {
    diagnostics_.error(code::kNotAskable, ask.target->place, std::move(message),
                       "VAR count = 0, then ASK \"how many? \" INTO count");
  };
  if (root == nullptr || root->symbol->kind == Symbol::Kind::Signal) {
    return refuse("ASK fills a variable, or a part of one");
  }
  if (!assignable(*root->symbol, ask.target->place, diagnostics_) || !type.known()) return;
  const auto* const member = std::get_if<Member>(&ask.target->node);
  const bool angle = member != nullptr && angle_of(member->object->type, member->field);
  if (!type.scalar() || angle) {
    refuse(fmt::format("ASK reads a number, a text, or TRUE or FALSE; this is {}",
                       angle ? "an angle of a pose" : in_words(type)));
  }
}

void StatementChecker::check(Expect& expectation) {
  require_test("EXPECT");
  expressions_.check_condition(expectation.condition, "EXPECT");
}

void StatementChecker::check(Simulate& simulation) {
  require_test("SIMULATE");
  signals_.check(simulation);
}

/// Reports what only a TEST may do: the program itself is run on machines that are there.
void StatementChecker::require_test(std::string_view word) {
  const Routine* const routine = inside_.around != nullptr ? inside_.around : inside_.routine;
  if (routine != nullptr && routine->test) return;
  diagnostics_.error(code::kOutsideTest, place_, fmt::format("{} can stand only in a TEST", word),
                     "TEST \"its name\" … ENDTEST holds it; a program has ASSERT and its inputs");
}

// Flow

void StatementChecker::check(Wait& wait) {
  waits_.check(wait, inside_.routine);
  check(wait.otherwise);
}

void StatementChecker::check(If& conditional) {
  bool settled = false;
  for (If::Branch& branch : conditional.branches) {
    if (settled) values_.enter_unreached();
    expressions_.check_condition(branch.condition, "IF");
    if (settled) values_.leave_unreached();
    check_guarded(branch.body, settled || is_constant(branch.condition, false));
    settled = settled || is_constant(branch.condition, true);
  }
  check_guarded(conditional.otherwise, settled);
}

void StatementChecker::check(Select& select) {
  const Type type = expressions_.check(select.selector);
  if (!type.scalar()) {
    diagnostics_.error(code::kTypeMismatch, select.selector->place,
                       fmt::format("SELECT compares single values; this is {}", in_words(type)),
                       "select by one of its parts");
    select.selector->type = Type{};
  }
  CaseLines lines;
  for (Select::Case& one : select.cases) {
    for (const ExprPtr& value : one.values) {
      expressions_.check(value);
      if (select.selector && value) check_case(select.selector->type, *value, lines);
    }
    check(one.body);
  }
  check(select.otherwise);
  if (select.selector && select.selector->type.is(Type::Kind::Enum)) {
    warn_of_missing_cases(select, lines, diagnostics_);
  }
}

/// The value must be of the selector's kind, and may not stand in a CASE above it.
void StatementChecker::check_case(const Type& wanted, const Expr& value, CaseLines& lines) {
  const Type& type = value.type;
  if (wanted.kind == Type::Kind::Unknown || type.kind == Type::Kind::Unknown) return;
  if (common_type(wanted, type).kind == Type::Kind::Unknown) {
    values_.accept(value, wanted, "the SELECT compares with");
    return;
  }
  if (!known(value.constant)) return;
  const auto [earlier, added] =
      lines.try_emplace(converted(value.constant, wanted), value.place.line);
  if (added) return;
  diagnostics_.error(
      code::kCaseTwice, value.place,
      fmt::format("this value stands in line {} already: its CASE is taken", earlier->second),
      "leave it out here");
}

void StatementChecker::check(While& loop) {
  expressions_.check_condition(loop.condition, "WHILE");
  check_body(loop.body, is_constant(loop.condition, false));
}

void StatementChecker::check(For& loop) {
  const bool elements = expressions_.check(loop.elements).known();
  const Type type = loop.elements == nullptr ? check_range(loop)
                    : elements               ? check_elements(loop, values_, diagnostics_)
                                             : Type{};
  const Declarations::OpenScope scope(declarations_);
  loop.symbol = declarations_.declare(Symbol::Kind::LoopVariable, loop.variable,
                                      loop.variable_place, type, {});
  check_body(loop.body, false);
}

/// The type of the loop variable: what first value, last value and step have in common.
Type StatementChecker::check_range(For& loop) {
  Type type;
  for (const ExprPtr* part : {&loop.from, &loop.to, &loop.step}) {
    const Type next = expressions_.check(*part);
    if (*part == nullptr || next.kind == Type::Kind::Unknown) continue;
    if (!next.numeric()) {
      diagnostics_.error(code::kTypeMismatch, (*part)->place,
                         "FOR counts with numbers; this is " + described(**part));
      return {};
    }
    const Type common = common_type(type, next);
    if (!common.numeric()) {
      diagnostics_.error(code::kDimensionMismatch, (*part)->place,
                         fmt::format("this is {}; the FOR began with {}{}", described(**part),
                                     in_words(type), not_as_written((*part)->type, type)),
                         "first value, last value and STEP need the same unit");
      return {};
    }
    type = common;
  }
  if (loop.step == nullptr && !type.dimension.none()) {
    diagnostics_.error(code::kStepMissing, loop.variable_place,
                       fmt::format("a FOR over {} needs a STEP", in_words(type)),
                       "for example STEP " + example_of(type.dimension));
    return type;
  }
  check_constant_range(loop, type);
  return type;
}

void StatementChecker::check_constant_range(For& loop, const Type& type) {
  if (loop.from == nullptr || loop.to == nullptr || !values_.reached()) return;
  const Constant step = loop.step == nullptr ? Constant(std::int64_t{1}) : loop.step->constant;
  if (!known(step) || type.kind == Type::Kind::Unknown) return;
  // The step alone can be wrong even where the range is not known.
  const bool range_known = known(loop.from->constant) && known(loop.to->constant);
  const Constant zero(std::int64_t{0});
  const Slot first = to_slot(converted(range_known ? loop.from->constant : zero, type));
  const Slot last = to_slot(converted(range_known ? loop.to->constant : zero, type));
  const Slot stride = to_slot(converted(step, type));
  std::int64_t turns = 0;
  const ArithmeticError error =
      type.kind == Type::Kind::Int
          ? arithmetic::turns(first.integer, last.integer, stride.integer, turns)
          : arithmetic::turns(first.real, last.real, stride.real, turns);
  loop.turns = range_known && error == ArithmeticError::None && turns > 0;
  if (error == ArithmeticError::None) return;
  const ArithmeticErrorText text = describe(error);
  diagnostics_.error(text.code, loop.step == nullptr ? loop.variable_place : loop.step->place,
                     std::string(text.message), std::string(text.help));
}

void StatementChecker::check_body(Block& body, bool unreached) {
  ++inside_.loops;
  check_guarded(body, unreached);
  --inside_.loops;
}

void StatementChecker::require_loop(std::string_view word) {
  if (inside_.loops > 0) return;
  diagnostics_.error(code::kMisplaced, place_,
                     fmt::format("{} can only stand inside LOOP, WHILE or FOR", word));
}

void StatementChecker::check(Try& statement) {
  check(statement.body);
  const Declarations::OpenScope scope(declarations_);
  Declaration::Declared& why = statement.why;
  if (!why.name.empty()) {
    why.symbol =
        declarations_.declare(Symbol::Kind::Variable, why.name, why.place, Type::string(), {});
  }
  ++inside_.rescues;
  check(statement.rescue);
  --inside_.rescues;
}

void StatementChecker::check(Raise& statement) {
  if (statement.value != nullptr) {
    expressions_.check(statement.value);
    values_.accept(*statement.value, Type::string(), "RAISE needs");
  } else if (inside_.rescues == 0) {
    diagnostics_.error(code::kNothingToRaise, place_,
                       "RAISE without a text raises the error of its RESCUE again; there is none",
                       "say what is wrong, for example RAISE \"no part\"");
  }
}

// Routines, TASKs and handlers

void StatementChecker::check(Routine& routine) {
  scopes_.enter_file(routine.place.file);
  inside_.routine = &routine;
  uses_.enter(&routine);
  expressions_.complete_header(routine);
  scopes_.enter();
  check_parameters(routine);
  for (Statement& statement : routine.body) check(statement);
  scopes_.leave();
  routine.memory = take_memory_use();
  uses_.enter(nullptr);
  inside_.routine = nullptr;
  if (routine.function) check_returns(routine, diagnostics_);
}

void StatementChecker::check_parameters(Routine& routine) {
  for (Routine::Parameters& group : routine.parameters) {
    if (group.value != nullptr) {
      expressions_.check(group.value);
      values_.accept(*group.value, group.type,
                     fmt::format("{} needs", shortened(group.names.front().name)));
      const bool unknown = group.value->type.kind == Type::Kind::Unknown;
      if (group.by_reference) {
        diagnostics_.error(code::kReferenceArgument, group.value->place,
                           "a REF parameter has no default", "it stands for a variable");
      } else if (!unknown && !known(group.value->constant)) {
        diagnostics_.error(code::kDefaultNotConstant, group.value->place,
                           "a default must be constant",
                           "give the value where the routine is called");
      }
    }
    for (Declaration::Declared& declared : group.names) {
      const Symbol* const symbol = declarations_.declare(Symbol::Kind::Variable, declared.name,
                                                         declared.place, group.type, {});
      if (group.by_reference) scopes_.refer(*symbol);
      declared.symbol = symbol;
    }
  }
}

void StatementChecker::check(Return& statement) {
  if (inside_.routine != nullptr && inside_.routine->handler) {
    diagnostics_.error(code::kMisplaced, place_, "RETURN cannot leave the handler of a WHEN",
                       "the program goes on where it was interrupted");
    return;
  }
  expressions_.check(statement.value);
  const bool wanted = inside_.routine != nullptr && inside_.routine->function;
  if (wanted && statement.value != nullptr) {
    values_.accept(*statement.value, inside_.routine->result,
                   fmt::format("{} returns", shortened(inside_.routine->name)));
  } else if (wanted) {
    diagnostics_.error(
        code::kReturnValue, place_,
        fmt::format("RETURN needs the value of {}", shortened(inside_.routine->name)),
        "for example RETURN " + example_of(inside_.routine->result.dimension));
  } else if (statement.value != nullptr) {
    diagnostics_.error(code::kReturnValue, statement.value->place,
                       inside_.routine == nullptr ? "the program has no value to return"
                                                  : "a PROC has no value to return",
                       "write RETURN alone, or make it a FUNC");
  }
}

void StatementChecker::check(Start& start) {
  const Symbol* symbol = scopes_.find(start.task.text);
  if (symbol == nullptr || symbol->kind != Symbol::Kind::Routine) {
    symbol = names_.resolve(start.task.text, start.task_place);
  }
  start.task.symbol = symbol;
  if (symbol == nullptr) return;
  if (symbol->routine == nullptr || !symbol->routine->task) {
    diagnostics_.error(code::kNotATask, start.task_place,
                       fmt::format("{} is no TASK", shortened(symbol->name)),
                       "START blink needs TASK blink … ENDTASK");
    return;
  }
  uses_.called(*symbol->routine, start.task_place);
}

void StatementChecker::check(When& when) {
  if (when.handled) return check_handler(when);
  const bool raises =
      !when.action.empty() && std::holds_alternative<Raise>(when.action.front().node);
  inside_.rescues += raises ? 1 : 0;  // check_when() reports what RAISE needs here
  check(when.action);
  inside_.rescues -= raises ? 1 : 0;
  watches_.check_when(when);
}

/// A handler is checked at its place in the text, because it sees what is declared there; it
/// becomes a routine.
void StatementChecker::check_handler(When& when) {
  watches_.check_when(when);
  const Place place = place_;
  Routine& handler = *std::ranges::find_if(
      routines_, [&](const Routine& one) { return one.handler && one.place == place; });
  when.handler = handler.index;
  uses_.called(handler, place);
  const Routine* const outer = uses_.enter(&handler);
  const Inside outside = inside_;
  inside_ = {.routine = &handler,
             .around = outside.around != nullptr ? outside.around : outside.routine};
  const Declarations::Count count = declarations_.count_anew();
  const bool memory = expressions_.take_memory_use();
  uses_.enter_handler(scopes_.declared());
  check(when.action);
  handler.body = std::move(when.action);
  handler.memory = take_memory_use();
  if (memory) expressions_.need_memory();
  declarations_.count_on(count);
  inside_ = outside;
  uses_.enter(outer);
}

bool StatementChecker::take_memory_use() {
  const bool many = declarations_.take_many();
  return expressions_.take_memory_use() || many;
}

}  // namespace rob::lang
