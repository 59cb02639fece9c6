#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "lang/check/fold.h"
#include "lang/check/missing_points.h"
#include "lang/check/routine_uses.h"
#include "lang/check/symbols.h"
#include "lang/machine/robot_signature.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"
#include "lang/values/builtins.h"

namespace rob::lang {

/// Settles the type, the dimension and, where there is one, the constant value of expressions, and
/// reports what does not fit together. What is wrong becomes Unknown, which fits everywhere.
class ExpressionChecker {
 public:
  /// `program` is searched for names that are declared elsewhere; types are completed in it.
  ExpressionChecker(Scopes& scopes, Program& program, const RobotSignature& robot,
                    RoutineUses& uses, MissingPoints& missing, Diagnostics& diagnostics)
      : scopes_(scopes),
        robot_(robot),
        program_(program),
        uses_(uses),
        missing_(missing),
        diagnostics_(diagnostics) {}

  /// `expression` may be null: what could not be read is Unknown.
  Type check(const ExprPtr& expression);

  /// A call that stands as a statement of its own.
  void check_statement(const ExprPtr& call);

  /// Checks that a checked expression can be given where `wanted` is needed: the same type, or an
  /// INT for a REAL. `needed` is the subject of the message: "the variable x needs".
  bool accept(const Expr& expression, const Type& wanted, std::string_view needed);

  /// Checks a condition; `word` is the statement it belongs to.
  void check_condition(const ExprPtr& condition, std::string_view word);

  /// What a name means here; null if nothing. No message.
  const Symbol* find(std::string_view name) const { return scopes_.find(name); }

  /// A symbol that may be used here; null, and a message, if there is none.
  const Symbol* resolve(std::string_view name, Place place);

  /// DIN[n], DOUT[n], AIN[n] or AOUT[n]; null, and a message, if n is no constant or the robot has
  /// no such channel.
  const Symbol* resolve_channel(Name& name, Place place);

  /// The type JOINTS.
  Type joints() const { return Type::joints(program_.types->joints.get()); }

  /// False, and a message, if it needs a force sensor that the robot does not have.
  bool has_sensor(Reading reading, Place place);

  // Arrays and records (check_arrays.cpp)
  /// Computes the length of an ARRAY in a written type; false, and a message at `place`, where that
  /// is faulty, or a record in it is not known yet.
  bool complete(const Type& type, Place place);
  /// The same for all types in the head of a routine.
  void complete_header(const Routine& routine);
  /// Whether a value was met that does not lie in registers, since it was last asked.
  void need_memory() { memory_use_ = true; }
  bool take_memory_use() { return std::exchange(memory_use_, false); }

  /// The value of a FRAME or a TOOL, which is fixed before the program runs: points are worth there
  /// what they are worth at the start. `missed`: one of them has no value, which has been noted.
  Type check_fixed(const ExprPtr& expression, bool& missed);

  /// The FRAME that a pose is in; null for the world, and where none was found.
  const Symbol* frame_of(const Type& pose) const;

  /// While constants say that a part of the program is never executed, a computation in it that
  /// must fail is no mistake: `IF n <> 0 THEN x = 10 / n` with CONST n = 0.
  void enter_unreached() { ++unreached_; }
  void leave_unreached() { --unreached_; }
  bool reached() const { return unreached_ == 0; }

 private:
  Type check_node(Expr& expression);
  Type check(const NumberLiteral& literal, Expr& expression);
  Type check(const BoolLiteral& literal, Expr& expression);
  Type check(const StringLiteral& literal, Expr& expression);
  Type check(const Tuple& tuple, Expr& expression);
  Type check(Name& name, Expr& expression);
  Type check(Unary& unary, Expr& expression);
  Type check(Binary& binary, Expr& expression);
  Type check(Call& call, Expr& expression);
  Type check(Member& member, Expr& expression);
  Type check(Index& index, Expr& expression);
  Type check(List& list, Expr& expression);

  Type check_logical(Binary& binary, Expr& expression);
  Type check_comparison(const Binary& binary, const Expr& expression);
  Type check_sum(const Binary& binary, const Expr& expression);
  Type check_product(const Binary& binary, const Expr& expression);
  Type check_division(const Binary& binary, const Expr& expression);
  Type check_power(const Binary& binary, const Expr& expression);
  Type check_arguments(const Builtin& builtin, const Call& call, Place place);
  Type check_texts(const Builtin& builtin, const Call& call);
  bool check_unit(const Expr& value, const Expr& unit_text);
  Type common_dimension(const Call& call);
  // Poses (check_poses.cpp)
  Type common_frame(const Expr& left, const Expr& right, std::string_view what);
  bool fits_place(const Expr& expression, const Type& wanted) const;
  Type check_to_frame(const Call& call);
  Type check_place_sum(const Binary& binary, const Expr& expression);
  Type check_place_product(const Binary& binary, const Expr& expression);
  Folded fold_places(const Binary& binary) const;
  static Type check_angle(const Member& member, int which, Expr& expression);
  Type check_places(const Builtin& builtin, const Call& call);

  Type check_vectors(const Builtin& builtin, const Call& call);

  // JOINTS, and what is read of a force sensor (check_joints.cpp)
  Type check_joints(const Call& call, Expr& expression);
  Type check_inverse(const Call& call);
  Type axis_type(const Index& index, const Type& joints);

  // Arrays (check_arrays.cpp)
  bool fits_memory(const Type& element, std::int64_t count, Place place);
  void settle_length(Program::ArrayLength& written);
  Type element_type(const Type& a, const Type& b);
  bool accept_list(const Expr& expression, const List& list, const Type& wanted,
                   std::string_view needed);
  static void fold_length(const Call& call, Expr& expression);

  // Records (check_records.cpp)
  Type check_record(Call& call, const Expr& expression, const Type& record);
  bool bind_field(Call& call, const Expr& value, const std::string& name);

  // Routines (check_routine_calls.cpp)
  Type check_routine_call(Call& call, const Expr& expression, const Routine& routine);
  bool bind(Call& call, Place place, const Routine& routine);
  bool check_argument(const Expr& argument, const Routine& routine,
                      const Routine::Parameters& group, std::string_view name);
  void report_unknown_function(std::string_view name, Place place);

  bool both_numbers(const Binary& binary);
  bool scales_vector(const Binary& binary) const;
  static bool scales_joints(const Binary& binary);
  Type unlike(const Binary& binary, const Expr& expression);
  Type bounded(Dimension dimension, const Expr& expression);
  void keep(const Folded& folded, Expr& expression);
  void fold_binary(const Binary& binary, Expr& expression);
  void fold_call(const Builtin& builtin, const Call& call, Expr& expression);
  void report_unknown(std::string_view name, Place place);
  // Names of other files (check_use.cpp)
  bool report_ambiguous(std::string_view name, Place place);
  void report_no_such_name(std::string_view name, Place place);
  const Builtin* resolve_function(const Call& call, Place place);

  Scopes& scopes_;
  const RobotSignature& robot_;
  Program& program_;
  RoutineUses& uses_;
  MissingPoints& missing_;
  Diagnostics& diagnostics_;
  int unreached_ = 0;
  bool memory_use_ = false;
  const Expr* statement_ = nullptr;  ///< the call that is a statement of its own
  bool fixed_ = false;               ///< inside of check_fixed()
  bool missed_ = false;              ///< there a point without a value was met
};

/// The value of a constant as its place wants it: of a pose that was moved, in the world.
Constant known_value(const Expr& expression);
/// "a length, 5mm": type and, where it is known, value; for messages.
std::string described(const Expr& expression);
/// The type that two operands share: INT, or REAL of their dimension, or BOOL or STRING; Unknown
/// if they do not fit together. One of them Unknown: the other.
Type common_type(const Type& a, const Type& b);
/// "+", "AND": as it is written.
std::string_view symbol_of(BinaryOp op);

}  // namespace rob::lang
