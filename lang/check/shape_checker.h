#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "lang/check/expression_checker.h"
#include "lang/check/value_checker.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Checks what a program says of contacts: OBSTACLE, the SHAPE of a TOOL, ALLOW.
class ShapeChecker {
 public:
  ShapeChecker(ExpressionChecker& expressions, ValueChecker& values, const RobotSignature& robot,
               const Program& program, Diagnostics& diagnostics)
      : expressions_(expressions),
        values_(values),
        robot_(robot),
        program_(program),
        diagnostics_(diagnostics) {}

  void check(ObstacleDeclaration& obstacle);
  /// The SHAPE of a TOOL, which becomes part of its value.
  void check_shape(const Declaration& tool, std::vector<double>& slots);
  /// The names after ALLOW, which become as they were declared.
  void check_names(Allow& allow);

 private:
  bool check_name(const ObstacleDeclaration& obstacle);
  bool check_count(const ObstacleDeclaration& obstacle);
  void check_values(ObstacleDeclaration& declaration);
  const std::vector<double>* constant(const ExprPtr& value, const Type& wanted,
                                      std::string_view needed);
  Vector3 vector(const ExprPtr& value, std::string_view needed);
  PoseValue pose(const ExprPtr& value, std::string_view needed);
  double length(const ExprPtr& value, std::string_view needed);
  CapsuleValue capsule(const ExprPtr& from, const ExprPtr& to, const ExprPtr& radius);
  std::string file(const ExprPtr& value);
  void refuse_computed(const Expr& value, std::string_view needed);
  std::vector<std::string> known_bodies() const;

  ExpressionChecker& expressions_;
  ValueChecker& values_;
  const RobotSignature& robot_;
  const Program& program_;
  Diagnostics& diagnostics_;
  std::map<std::string, Place> obstacles_;  ///< of all files, by their names in capitals
};

}  // namespace rob::lang
