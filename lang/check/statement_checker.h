#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "lang/check/checker.h"
#include "lang/check/expression_checker.h"
#include "lang/check/kept_names.h"
#include "lang/check/move_checker.h"
#include "lang/check/routine_uses.h"
#include "lang/check/symbols.h"
#include "lang/check/wait_checker.h"
#include "lang/check/watch_checker.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Private to the checker: checks statements, one check() for each kind.
class StatementChecker {
 public:
  StatementChecker(CheckedProgram& checked, const RobotSignature& robot, const PointTable& points,
                   const TargetJudge& judge, Diagnostics& diagnostics)
      : scopes_(checked.symbols, robot),
        uses_(checked.program.routines.size()),
        expressions_(scopes_, checked.program, robot, uses_, missing_, diagnostics),
        moves_(robot, expressions_, judge, diagnostics, checked),
        clauses_(expressions_, diagnostics),
        features_(checked.features),
        waits_(expressions_, diagnostics),
        watches_(expressions_, diagnostics),
        points_(points),
        taught_(checked.program.taught),
        missing_points_(checked.missing_points),
        kept_names_(scopes_, uses_, checked.known),
        diagnostics_(diagnostics),
        routines_(checked.program.routines),
        entry_(checked.program.entry) {}

  /// The top level first, then the routines, which see all its names.
  void check(Program& program, KnownNames known);

 private:
  /// What the present statement stands in, up to the routine or handler that it belongs to.
  struct Inside {
    const Routine* routine = nullptr;  ///< null at the top level
    const Routine* around = nullptr;   ///< around the handler, if it is one
    Slots declared{};                  ///< by the variables of it that are known here
    Slots most_declared{};             ///< of it
    int loops = 0;                     ///< open
    int rescues = 0;                   ///< RESCUE blocks open
  };

  /// At the prompt the last routine of a name holds, and the last of what has a value. Types stay:
  /// there are values of them.
  bool may_be_anew(Symbol::Kind kind, const Symbol& earlier) const {
    using Kind = Symbol::Kind;
    const bool alike = (kind == Kind::Routine) == (earlier.kind == Kind::Routine);
    const bool types = kind == Kind::Record || earlier.kind == Kind::Record;
    return entry_ != 0 && scopes_.at_top_level() && alike && !types;
  }
  /// A block is a scope: what it declares lives to its end.
  void check(Block& block) {
    const Slots declared = inside_.declared;
    scopes_.enter();
    for (Statement& statement : block) check(statement);
    moves_.warn_of_zones(block);
    scopes_.leave();
    inside_.declared = declared;
  }
  void check(Statement& statement) {
    place_ = statement.place;
    uses_.statement(statement);
    std::visit([&](auto& node) { check(node); }, statement.node);
    if (in_path_) check_in_path(statement);
  }
  void check(Move& move) { moves_.check(move, place_, false); }
  void check(PlainMotions& motions) { moves_.check(motions); }
  void check(WatchedMotion& watched) {
    check_watched(watched);
    if (watched.until != nullptr) watches_.check_until(watched.until);
    check(watched.otherwise);
    for (WayPoint& event : watched.events) {
      check(event.action);
      watches_.check_event(event);
    }
  }
  void check(When& when) {
    if (when.handled) return check_handler(when);
    const bool raises =
        !when.action.empty() && std::holds_alternative<Raise>(when.action.front().node);
    inside_.rescues += raises ? 1 : 0;  // check_when() tells what RAISE needs here
    check(when.action);
    inside_.rescues -= raises ? 1 : 0;
    watches_.check_when(when);
  }
  // Handlers (check_handlers.cpp)
  void check_handler(When& when);
  void settle_handlers();
  void check(Stop&) {}
  void check(Brake&) {}
  // HALT and ASK (check_operator.cpp)
  void check(Halt& halt);
  void check(Ask& ask);
  void check_operators_simulation(const Simulate& simulation);
  void check(Declaration& declaration);
  // WITH, PATH, PRESS, OVERRIDE (check_surroundings.cpp)
  void check(With& with);
  void check(PathBlock& path);
  void check(WayPoint& event);
  void check(Press& press);
  void check(SetOverride& statement) { clauses_.check_override(statement.share); }
  void check(Load& load);  // check_frames.cpp
  void check_watched(WatchedMotion& watched);
  void check_test_names(const Program& program);
  void check_in_path(const Statement& statement);
  void check_motion_in_path(const Move& move, Place place);
  void check_not_read(const ExprPtr& value);
  void report_reads_in_paths();
  void check_path_clauses(const Clauses& clauses, Place place);

  // TEST (check_tests.cpp)
  void check(Expect& expectation);
  void check(Simulate& simulation);
  void check_simulated_force(Simulate& simulation, const Symbol& symbol);
  void require_test(std::string_view word);

  // Signals (check_signals.cpp)
  const Symbol* resolve_signal(Name& name, Place place);
  void check(SignalDeclaration& signal);
  void check(Pulse& pulse);
  // RECORD (check_records.cpp)
  void check(RecordDeclaration& record);
  void add_field(TypeDetail& detail, const Declaration::Declared& field, const Type& type);
  /// Whether the routine, or the top level, that has been checked needs memory behind its
  /// registers.
  bool take_memory_use();
  void check_digital(const SignalDeclaration& signal, const Symbol& channel);
  void check_analog(const SignalDeclaration& signal, Symbol& symbol);
  void check_scale(const SignalDeclaration& signal, Symbol& symbol);
  std::optional<double> constant_end(const Expr& end);
  void check_safe(SignalDeclaration& signal, const Symbol& symbol);
  std::optional<double> safe_value(const Expr& safe, const Symbol& symbol);

  void check(Assign& assign);
  void check(Print& print) {
    for (const ExprPtr& value : print.values) expressions_.check(value);
  }
  void check(Wait& wait) {
    waits_.check(wait, inside_.routine);
    check(wait.otherwise);
  }
  void check(If& conditional);
  void check(While& loop);
  void check(For& loop);
  void check(Loop& loop);
  void check(Select& select);
  void check(Exit&) { require_loop("EXIT"); }
  void check(Next&) { require_loop("NEXT"); }
  void check(Assert& assertion) { expressions_.check_condition(assertion.condition, "ASSERT"); }

  void check(Try& statement);
  void check(Raise& statement);

  void check(CallStatement& statement) { expressions_.check_statement(statement.call); }
  void check(Return& statement);

  // Frames (check_frames.cpp)
  void check_frame(const Declaration& declaration, Constant& value, bool missed);
  Constant tool_number(const ExprPtr& value, const Type& wanted, std::string_view needed);
  void check_frame_uses(const Program& program);

  // USE (check_use.cpp)
  void check(Use& use);
  void warn_of_hiding(const std::string& name, const Place& place, const std::string& file);

  // POINT and TEACH (check_points.cpp)
  void check(PointDeclaration& declaration);
  void check(Teach& teach);
  bool is_of_other_file(const Declaration::Declared& point);
  void check(ZeroForce&) { expressions_.has_sensor(Reading::Force, place_); }
  Type type_of(const PointTable::Point& kept, Place place);
  void warn_of_missing_points();

  // TASK and START (check_tasks.cpp)
  void check(Start& start);
  void settle_tasks(const Program& program);

  // Routines (check_routines.cpp)
  void declare(KnownNames known);
  void declare(const Routine& routine);
  void check(Routine& routine);
  void check_returns(const Routine& routine);
  void check_parameters(Routine& routine);

  /// Whether the name has a meaning already: an error or a warning.
  void warn_of_name(Symbol::Kind kind, const std::string& name, Place place);
  const Symbol* declare(Symbol::Kind kind, const std::string& name, Place place, Type type,
                        Constant value);
  /// Checks a block that is never executed if `unreached`.
  void check_guarded(Block& block, bool unreached);
  Type check_range(For& loop);
  void check_constant_range(For& loop, const Type& type);
  /// EXIT and NEXT belong to the innermost loop.
  void require_loop(std::string_view word);
  void check_body(Block& body);
  /// The line of each constant value of a SELECT.
  using CaseLines = std::map<Constant, std::uint32_t>;
  void check_case(const Type& wanted, const Expr& value, CaseLines& lines);
  bool assignable(const Symbol& symbol, Place place);

  Scopes scopes_;
  RoutineUses uses_;
  MissingPoints missing_;
  ExpressionChecker expressions_;
  MoveChecker moves_;
  ClauseChecker clauses_;
  std::vector<FeatureUse>& features_;
  WaitChecker waits_;
  WatchChecker watches_;
  const PointTable& points_;
  const std::set<std::string>& taught_;
  std::vector<MissingPoint>& missing_points_;
  KeptNames kept_names_;
  Diagnostics& diagnostics_;
  std::map<int, Place> safe_lines_;  ///< where a signal's SAFE value stands, by its number
  std::map<std::string, Place> points_declared_;  ///< of all files, by their names in capitals
  Place place_;                                   ///< of the present statement
  Inside inside_;
  bool in_path_ = false;                  ///< inside of PATH
  bool pressing_ = false;                 ///< inside of PRESS
  std::vector<const Expr*> path_values_;  ///< what PATHs are computed from
  std::vector<Routine>& routines_;
  std::uint32_t entry_;  ///< as Program::entry
};

}  // namespace rob::lang
