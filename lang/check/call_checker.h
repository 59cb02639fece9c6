#pragma once

#include <string>
#include <string_view>

#include "lang/check/routine_uses.h"
#include "lang/check/value_checker.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"
#include "lang/values/builtins.h"

namespace rob::lang {

/// Settles calls of built-in functions whose arguments have been checked.
class BuiltinChecker {
 public:
  /// `joints`: the type JOINTS of the robot; `text_list`: LIST OF STRING.
  BuiltinChecker(ValueChecker& values, RoutineUses& uses, const RobotSignature& robot, Type joints,
                 Type text_list, Diagnostics& diagnostics)
      : values_(values),
        uses_(uses),
        robot_(robot),
        joints_(joints),
        text_list_(text_list),
        diagnostics_(diagnostics) {}

  /// True, and a message, for one that has a value in place of a statement, or the other way
  /// round, and for a REF where nothing is changed.
  bool stands_wrong(const Builtin& builtin, const Call& call, bool statement, Place place);
  /// `sound`: all arguments have a type.
  Type check(const Builtin& builtin, const Call& call, bool sound, Expr& expression);
  /// The type of `j[i]`: it must be known which axis is meant, unless all take values of one
  /// dimension.
  Type axis_type(const Index& index);
  /// False, and a message, if it needs a force sensor that the robot does not have.
  bool has_sensor(Reading reading, Place place);
  Type joints() const { return joints_; }

 private:
  Type type_of(const Builtin& builtin, const Call& call, Place place);
  Type common_dimension(const Call& call);
  Type check_root(const Call& call);
  Type check_ordinal(const Expr& value);
  Type check_row_number(const Builtin& builtin, const Expr& row);
  Type check_sort(const Expr& row);
  Type check_list(const Builtin& builtin, const Call& call);
  Type check_parts(const Builtin& builtin, const Call& call);
  bool accept_changed(const Builtin& builtin, const Expr& variable);
  Type check_vectors(const Builtin& builtin, const Call& call);
  Type check_poses(const Builtin& builtin, const Call& call);
  bool accept_pose(const Builtin& builtin, const Expr& argument, const Expr*& first, Type& frame);
  Type check_to_frame(const Call& call);
  Type check_joints(const Call& call, Expr& expression);
  Type check_inverse(const Call& call);
  Type check_texts(const Builtin& builtin, const Call& call);
  bool check_unit(const Expr& value, const Expr& unit_text);
  void fold_known(const Builtin& builtin, const Call& call, Expr& expression);

  ValueChecker& values_;
  RoutineUses& uses_;
  const RobotSignature& robot_;
  Type joints_;
  Type text_list_;
  Diagnostics& diagnostics_;
};

/// Settles calls of the program's own routines, and of records, whose arguments have been checked.
class CallChecker {
 public:
  CallChecker(ValueChecker& values, RoutineUses& uses, Diagnostics& diagnostics)
      : values_(values), uses_(uses), diagnostics_(diagnostics) {}

  /// `statement`: the call is a statement of its own.
  Type check_routine(Call& call, Place place, const Routine& routine, bool statement);
  /// `part(width: 20mm)`: what is left out takes its default.
  Type check_record(Call& call, Place place, const Type& record, bool statement);

 private:
  bool bind(Call& call, Place place, const Routine& routine);
  bool check_argument(const Expr& argument, const Routine& routine,
                      const Routine::Parameters& group, std::string_view name);
  bool bind_field(Call& call, const Expr& value, const std::string& name);
  bool refuse(std::string_view code, Place place, std::string message, std::string help = "");

  ValueChecker& values_;
  RoutineUses& uses_;
  Diagnostics& diagnostics_;
};

}  // namespace rob::lang
