#pragma once

#include <cstdint>
#include <string_view>
#include <utility>

#include "lang/check/call_checker.h"
#include "lang/check/names.h"
#include "lang/check/operator_checker.h"
#include "lang/check/routine_uses.h"
#include "lang/check/symbols.h"
#include "lang/check/value_checker.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Settles the type, the dimension and, where there is one, the constant value of expressions, and
/// reports what does not fit together. A faulty one becomes Unknown, which fits everywhere.
class ExpressionChecker {
 public:
  /// Types are completed in `program`.
  ExpressionChecker(Scopes& scopes, Program& program, Names& names, ValueChecker& values,
                    const RobotSignature& robot, RoutineUses& uses, MissingPoints& missing,
                    Diagnostics& diagnostics)
      : scopes_(scopes),
        program_(program),
        names_(names),
        values_(values),
        uses_(uses),
        missing_(missing),
        diagnostics_(diagnostics),
        operators_(values, diagnostics),
        builtins_(values, uses, robot, Type::joints(program.types->joints.get()),
                  program.types->list(Type::string()), diagnostics),
        calls_(values, uses, diagnostics) {}

  /// `expression` may be null: what could not be read is Unknown.
  Type check(const ExprPtr& expression);
  /// A call that stands as a statement of its own.
  void check_statement(const ExprPtr& call);
  /// Checks a condition; `word` is the statement it belongs to.
  void check_condition(const ExprPtr& condition, std::string_view word);
  /// Where `wanted` is needed, as for ValueChecker::accept(); the expression may be null.
  bool check_as(const ExprPtr& expression, const Type& wanted, std::string_view needed);
  /// The value of a FRAME or a TOOL, which is fixed before the program runs, so a point has its
  /// value from the start of the program. `missed` becomes true if a point has no value; the
  /// message is already written.
  Type check_fixed(const ExprPtr& expression, bool& missed);

  /// DIN[n], DOUT[n], AIN[n] or AOUT[n]; null, and a message, if n is no constant or the robot has
  /// no such channel.
  const Symbol* resolve_channel(Name& name, Place place);
  /// The type JOINTS.
  Type joints() const { return builtins_.joints(); }
  /// False, and a message, if it needs a force sensor that the robot does not have.
  bool has_sensor(Reading reading, Place place) { return builtins_.has_sensor(reading, place); }

  /// Computes the length of an ARRAY in a written type; false, and a message at `place`, where that
  /// is faulty, or a record in it is not known yet.
  bool complete(const Type& type, Place place);
  /// The message that a LIST is no part of another value.
  void refuse_list_inside(Place place);
  /// The same for all types in the head of a routine.
  void complete_header(const Routine& routine);
  /// Whether a value was met that does not lie in registers, since it was last asked.
  void need_memory() { memory_use_ = true; }
  bool take_memory_use() { return std::exchange(memory_use_, false); }

 private:
  // One for each kind of node
  Type check(const NumberLiteral& literal, Expr& expression);
  Type check(const BoolLiteral& literal, Expr& expression);
  Type check(const StringLiteral& literal, Expr& expression);
  Type check(Name& name, Expr& expression);
  Type check(Unary& unary, Expr& expression);
  Type check(Binary& binary, Expr& expression);
  Type check(Call& call, Expr& expression);
  Type check(const Tuple& tuple, Expr& expression);
  Type check(Member& member, Expr& expression);
  Type check(Index& index, Expr& expression);
  Type check(List& list, Expr& expression);
  /// `colour.red`.
  Type check_enumerator(Member& member, Name& name, Expr& expression);
  Type check(Chain& chain, Expr& expression);
  Type check_logical(Binary& binary, Expr& expression);

  Type element_type(const Type& a, const Type& b);
  bool fits_memory(const Type& element, std::int64_t count, Place place);
  void settle_length(Program::ArrayLength& written);

  Scopes& scopes_;
  Program& program_;
  Names& names_;
  ValueChecker& values_;
  RoutineUses& uses_;
  MissingPoints& missing_;
  Diagnostics& diagnostics_;
  OperatorChecker operators_;
  BuiltinChecker builtins_;
  CallChecker calls_;
  bool memory_use_ = false;
  const Expr* statement_ = nullptr;  ///< the call that is a statement of its own
  bool fixed_ = false;               ///< inside of check_fixed()
  bool missed_ = false;              ///< there a point without a value was met
};

}  // namespace rob::lang
