#pragma once

#include <cstddef>
#include <vector>

#include "lang/compile.h"
#include "lang/expression_checker.h"
#include "lang/robot_signature.h"

namespace rob::lang {

/// Checks motions: the target tuple against the robot's coordinates, and the clauses.
///
/// A dimensionless AT is a share of all maxima, and the program has to show that it is meant as
/// one: `AT 50%`, or a REAL variable as in `AT slow`. An INT, or an expression of nothing but bare
/// literals, is refused, since `AT 50` is far more likely to be a speed without its unit.
class MoveChecker {
 public:
  MoveChecker(const RobotSignature& robot, ExpressionChecker& expressions, Diagnostics& diagnostics,
              std::vector<ConstantTarget>& constant_targets)
      : robot_(robot),
        expressions_(expressions),
        diagnostics_(diagnostics),
        constant_targets_(constant_targets) {}

  void check(const Move& move);

 private:
  bool check_target(const Expr& target);
  bool check_shape(const Tuple& tuple, Place place);
  bool check_names(const Tuple& tuple);
  bool check_component(const Tuple::Element& element, std::size_t coordinate);
  bool check_at(const Expr& at);
  bool check_over(const Expr& over);
  bool check_positive(const Expr& value, std::string_view word);
  void remember_constants(const Move& move);

  const RobotSignature& robot_;
  ExpressionChecker& expressions_;
  Diagnostics& diagnostics_;
  std::vector<ConstantTarget>& constant_targets_;
};

}  // namespace rob::lang
