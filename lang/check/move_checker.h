#pragma once

#include <string_view>

#include "lang/check/checker.h"
#include "lang/check/clause_checker.h"
#include "lang/check/expression_checker.h"
#include "lang/check/plain_targets.h"
#include "lang/check/target.h"
#include "lang/machine/robot_signature.h"

namespace rob::lang {

/// Checks motions: the target against the robot's coordinates or axes, and the clauses.
class MoveChecker {
 public:
  MoveChecker(const RobotSignature& robot, ExpressionChecker& expressions, const TargetJudge& judge,
              Diagnostics& diagnostics, CheckedProgram& checked)
      : robot_(robot),
        plain_(robot),
        judge_(judge),
        expressions_(expressions),
        clauses_(expressions, diagnostics),
        diagnostics_(diagnostics),
        checked_(checked) {}

  /// `place`: of the statement; `guarded`: UNTIL stands behind it.
  void check(const Move& move, Place place, bool guarded);
  void check(PlainMotions& motions);
  /// What follows stands in a routine, or no more.
  void in_routine(bool inside) { in_routine_ = inside; }
  /// The same for a block of WITH.
  void enter_surroundings() { ++surroundings_; }
  void leave_surroundings() { --surroundings_; }
  /// A ZONE before UNTIL, or directly before STOP, WAIT and the like, which make its target exact.
  void warn_of_zones(const Block& block);

 private:
  bool check_joint(const Move& move);
  bool check_target(const Move& move, const ExprPtr& target);
  // check_computed_targets.cpp
  bool check_value(const Move& move, const ExprPtr& target);
  bool check_frame(const Move& move, const Expr& target);
  void report_no_target(const Move& move, const Expr& target);
  void judge_value(const Expr& target, const Symbol* point);

  // Curves, SPIRAL, JOG (check_curves.cpp)
  bool check_way(const Move& move, Place place, bool guarded);
  bool check_curve(const Move& move);
  bool check_alike(const Move& move);
  bool check_spiral(const Move& move);
  bool check_jog(const Move& move, Place place, bool guarded);
  bool check_positive(const ExprPtr& value, const Type& wanted, std::string_view word);
  bool check_clauses_of(const Move& move);
  bool refuse_clause(std::string_view clause, Place place, std::string message, std::string help);

  bool check_shape(const Tuple& tuple, const Coordinates& coordinates, Place place);
  bool check_names(const Tuple& tuple, const Coordinates& coordinates);
  bool check_component(std::string_view word, const Tuple::Element& element,
                       std::size_t coordinate);
  void warn_of_zone(const Expr& zone, std::string_view word, Place place);
  void remember_features(const Move& move, Place place);
  bool places_are_known() const;
  void judge_constants(const Move& move);
  void judge_target(const Expr& target, const Symbol* point);
  void judge(const MoveCommand& command, Place place);
  void keep_component(MoveCommand& command, std::size_t i, const Expr& value,
                      Dimension dimension) const;
  // check_plain_motions.cpp
  bool settle(PlainMotions& motions, PlainMotions::Written& motion);

  const RobotSignature& robot_;
  PlainTargets plain_;
  const TargetJudge& judge_;
  ExpressionChecker& expressions_;
  ClauseChecker clauses_;
  Diagnostics& diagnostics_;
  CheckedProgram& checked_;
  bool in_routine_ = false;
  int surroundings_ = 0;  ///< WITHs that are open around the motion
};

}  // namespace rob::lang
