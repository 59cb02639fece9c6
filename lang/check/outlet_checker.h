#pragma once

#include <type_traits>

#include "lang/check/expression_checker.h"
#include "lang/check/names.h"
#include "lang/check/routine_uses.h"
#include "lang/check/value_checker.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

template <typename Node>
concept IsOutlet = std::is_same_v<Node, Write> || std::is_same_v<Node, Read> ||
    std::is_same_v<Node, Send> || std::is_same_v<Node, Receive>;

/// Whether a variable of this symbol may be given a value; reports why not.
bool assignable(const Symbol& symbol, Place place, Diagnostics& diagnostics);

/// Statements on files and devices.
class OutletChecker {
 public:
  OutletChecker(Names& names, ExpressionChecker& expressions, ValueChecker& values,
                RoutineUses& uses, Diagnostics& diagnostics)
      : names_(names),
        expressions_(expressions),
        values_(values),
        uses_(uses),
        diagnostics_(diagnostics) {}

  void check(Write& write);
  void check(Read& read);
  void check(Send& send);
  /// Its ELSE is not looked at.
  void check(Receive& receive);

 private:
  Names& names_;
  ExpressionChecker& expressions_;
  ValueChecker& values_;
  RoutineUses& uses_;
  Diagnostics& diagnostics_;
};

}  // namespace rob::lang
