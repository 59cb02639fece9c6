#pragma once

#include <string>
#include <string_view>

#include "lang/check/fold.h"
#include "lang/check/symbols.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// A type as programs write it: "INT", "LENGTH", "ARRAY[3] OF REAL", the name of a RECORD.
std::string as_written(const Type& type);
/// " (INT, not REAL)": two types that differ, as programs write them.
std::string not_as_written(const Type& given, const Type& wanted);
/// A variable, or a part of one, as programs write it: "k", "part.size", "a[…]".
std::string place_text(const Expr& place);
/// "a length, 5mm": type and, where it is known, value; for messages.
std::string described(const Expr& expression);
/// "IN pallet": the frame of a pose.
std::string frame_in_words(const Type& pose);
/// The type that two operands share: INT, or REAL of their dimension, or BOOL or STRING; Unknown
/// if they do not fit together. One of them Unknown: the other.
Type common_type(const Type& a, const Type& b);
/// "+", "AND": as it is written.
std::string_view symbol_of(BinaryOp op);

/// Whether checked expressions fit where they stand, and what is known of their values before the
/// program runs.
class ValueChecker {
 public:
  ValueChecker(const Scopes& scopes, Diagnostics& diagnostics)
      : scopes_(scopes), diagnostics_(diagnostics) {}

  /// Checks that an expression can be given where `wanted` is needed: the same type, or an INT for
  /// a REAL. `needed` is the subject of the message: "the variable x needs".
  bool accept(const Expr& expression, const Type& wanted, std::string_view needed);
  /// True, and a message, for a value of any number of elements as a whole: only its elements can
  /// be used, and what goes through all of them.
  bool refuse_open(const Expr& expression);
  /// The same for [], where it is no LIST.
  bool refuse_empty(const Expr& expression);
  /// Checks a number that is known: above zero, or a time of 0s or more.
  bool require_positive(const Expr& value, std::string_view word);
  void require_time(const Expr& time, std::string_view word);
  /// The name of a file, where it is known already. `word`: what uses it.
  void check_file(const ExprPtr& name, std::string_view word);
  /// REAL of a dimension; Unknown, and a message, if its exponents are too high.
  Type bounded(Dimension dimension, const Expr& expression);
  /// The frame that two poses share; a free one takes the other's. Unknown, and a message, if they
  /// are in two. `what`: needs them to share one.
  Type common_frame(const Expr& left, const Expr& right, std::string_view what);
  /// The FRAME that a pose is in; null for the world, and where none was found.
  const Symbol* frame_of(const Type& pose) const;

  /// Keeps what is known of a value; an error where it cannot be computed.
  void keep(const Folded& folded, Expr& expression);
  /// While constants say that a part of the program is never executed, a computation in it that
  /// must fail is no mistake: `IF n <> 0 THEN x = 10 / n` with CONST n = 0.
  void enter_unreached() { ++unreached_; }
  void leave_unreached() { --unreached_; }
  bool reached() const { return unreached_ == 0; }

 private:
  bool accept_list(const Expr& expression, const List& list, const Type& wanted,
                   std::string_view needed);
  bool accept_elements(const List& list, const Type& wanted, std::string_view needed);
  bool fits_place(const Expr& expression, const Type& wanted) const;

  const Scopes& scopes_;
  Diagnostics& diagnostics_;
  int unreached_ = 0;
};

}  // namespace rob::lang
