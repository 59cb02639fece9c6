#pragma once

#include <string_view>

#include "lang/checker.h"
#include "lang/clause_checker.h"
#include "lang/expression_checker.h"
#include "lang/robot_signature.h"

namespace rob::lang {

/// Checks motions: the target against the robot's coordinates or axes, and the clauses.
class MoveChecker {
 public:
  MoveChecker(const RobotSignature& robot, ExpressionChecker& expressions, Diagnostics& diagnostics,
              CheckedProgram& checked)
      : robot_(robot),
        expressions_(expressions),
        clauses_(expressions, diagnostics),
        diagnostics_(diagnostics),
        checked_(checked) {}

  void check(const Header& header);
  /// `place`: of the statement.
  void check(const Move& move, Place place);
  /// A ZONE before UNTIL, or directly before STOP or WAIT, which make its target exact.
  void warn_of_zones(const Block& block);

 private:
  bool check_joint(const Move& move);
  bool check_target(const Move& move);
  // check_computed_targets.cpp
  bool check_value(const Move& move);
  void report_no_target(const Move& move, const Type& type);
  void remember_value(const Move& move);

  bool check_shape(const Tuple& tuple, Place place);
  bool check_names(const Tuple& tuple);
  bool check_component(const Tuple::Element& element, std::size_t coordinate);
  void warn_of_zone(const Expr& zone, std::string_view word, Place place);
  void remember_features(const Clauses& clauses, Place place);
  void remember_constants(const Move& move);

  const RobotSignature& robot_;
  ExpressionChecker& expressions_;
  ClauseChecker clauses_;
  Diagnostics& diagnostics_;
  CheckedProgram& checked_;
};

}  // namespace rob::lang
