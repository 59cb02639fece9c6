#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "lang/check/checked_program.h"
#include "lang/check/clause_checker.h"
#include "lang/check/declaration_checker.h"
#include "lang/check/expression_checker.h"
#include "lang/check/move_checker.h"
#include "lang/check/names.h"
#include "lang/check/outlet_checker.h"
#include "lang/check/routine_uses.h"
#include "lang/check/shape_checker.h"
#include "lang/check/signal_checker.h"
#include "lang/check/symbols.h"
#include "lang/check/value_checker.h"
#include "lang/check/watch_checker.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Checks statements, one check() for each kind, and routines.
class StatementChecker {
 public:
  StatementChecker(CheckedProgram& checked, Scopes& scopes, Declarations& declarations,
                   Names& names, ExpressionChecker& expressions, ValueChecker& values,
                   MissingPoints& missing, RoutineUses& uses, const RobotSignature& robot,
                   const PointTable& points, const TargetJudge& judge, Diagnostics& diagnostics);

  void check(Statement& statement);
  void check(Routine& routine);
  /// Takes over a name that an earlier entry of the prompt has declared.
  void know(const KeptName& kept, const Symbol& symbol);
  /// Whether the routine, or the top level, that has been checked needs memory after its
  /// registers.
  bool take_memory_use();
  /// A ZONE that has no effect, at the top level.
  void warn_of_zones(const Block& block) { moves_.warn_of_zones(block); }
  /// From here on come the routines.
  void enter_routines() { moves_.in_routine(true); }
  /// Where all is checked, and it is known what TASKs change: what a WAIT waits for, and what a
  /// PATH reads.
  void report_waits_and_paths();

 private:
  /// The surroundings of the current statement, up to the routine or handler that it belongs to.
  struct Inside {
    const Routine* routine = nullptr;  ///< null at the top level
    const Routine* around = nullptr;   ///< around the handler, if it is one
    int loops = 0;                     ///< open
    int rescues = 0;                   ///< RESCUE blocks open
  };

  void check(Block& block);
  /// Checks a block that is never executed if `unreached`.
  void check_guarded(Block& block, bool unreached);

  // Motions
  void check(Move& move) { moves_.check(move, place_, false); }
  void check(PlainMotions& motions) { moves_.check(motions); }
  void check(WatchedMotion& watched);
  void check(WayPoint& event);
  void check(With& with);
  void check(Defaults& defaults);
  void remember_accel(const Clauses& clauses);
  void check(PathBlock& path);
  void check(Press& press);
  void check(Allow& allow);
  void check(SetOverride& statement) { clauses_.check_override(statement.share); }
  void check(Load& load);
  void check(Stop&) {}
  void check(Brake&) {}

  // Names and values
  template <IsDeclaration Declared>
  void check(Declared& declared) {
    declared_.check(declared);
  }
  void check(Teach& teach);
  void check(SignalDeclaration& signal) { signals_.check(signal); }
  void check(Pulse& pulse) { signals_.check(pulse); }
  void check(ZeroForce&) { expressions_.has_sensor(Reading::Force, place_); }
  void check(Use& use);
  void check(Assign& assign);
  void check(Print& print);

  // HALT, ASK, and TESTs
  /// WRITE, READ, SEND and RECEIVE.
  template <IsOutlet Outlet>
  void check(Outlet& outlet) {
    outlets_.check(outlet);
    if constexpr (std::is_same_v<Outlet, Receive>) check(outlet.otherwise);
  }
  void check(Halt& halt) { expressions_.check_as(halt.text, Type::string(), "HALT needs"); }
  void check(Ask& ask);
  void check(Assert& assertion) { expressions_.check_condition(assertion.condition, "ASSERT"); }
  void check(Expect& expectation);
  void check(Simulate& simulation);
  void require_test(std::string_view word);

  // Flow
  void check(Wait& wait);
  void check(If& conditional);
  void check(Select& select);
  /// The line of each constant value of a SELECT.
  using CaseLines = std::map<Constant, std::uint32_t>;
  void check_case(const Type& wanted, const Expr& value, CaseLines& lines);
  void check(While& loop);
  void check(For& loop);
  Type check_range(For& loop);
  void check_constant_range(For& loop, const Type& type);
  void check(Loop& loop) { check_body(loop.body, false); }
  void check_body(Block& body, bool unreached);
  void check(Exit&) { require_loop("EXIT"); }
  void check(Next&) { require_loop("NEXT"); }
  /// EXIT and NEXT belong to the innermost loop.
  void require_loop(std::string_view word);
  void check(Try& statement);
  void check(Raise& statement);

  // Routines, TASKs and handlers
  void check_parameters(Routine& routine);
  void check(CallStatement& statement) { expressions_.check_statement(statement.call); }
  void check(Return& statement);
  void check(Start& start);
  void check(When& when);
  void check_handler(When& when);
  Scopes& scopes_;
  Declarations& declarations_;
  Names& names_;
  ExpressionChecker& expressions_;
  ValueChecker& values_;
  RoutineUses& uses_;
  Diagnostics& diagnostics_;
  std::vector<FeatureUse>& features_;
  std::vector<Routine>& routines_;
  MoveChecker moves_;
  OutletChecker outlets_;
  PathChecker paths_;
  ClauseChecker clauses_;
  WatchChecker watches_;
  WaitChecker waits_;
  SignalChecker signals_;
  ShapeChecker shapes_;
  DeclarationChecker declared_;
  Place place_;  ///< of the current statement
  Inside inside_;
  std::uint32_t default_line_ = 0;  ///< where DEFAULT stands; 0: nowhere so far
  bool pressing_ = false;           ///< inside of PRESS
};

}  // namespace rob::lang
