#pragma once

#include <map>
#include <optional>

#include "lang/check/expression_checker.h"
#include "lang/check/names.h"
#include "lang/check/symbols.h"
#include "lang/check/value_checker.h"
#include "lang/syntax/ast.h"
#include "lang/text/diagnostic.h"

namespace rob::lang {

/// Checks SIGNAL, which names a channel and says what its volts stand for, PULSE and SIMULATE.
class SignalChecker {
 public:
  SignalChecker(Scopes& scopes, Declarations& declarations, Names& names,
                ExpressionChecker& expressions, ValueChecker& values, Diagnostics& diagnostics)
      : scopes_(scopes),
        declarations_(declarations),
        names_(names),
        expressions_(expressions),
        values_(values),
        diagnostics_(diagnostics) {}

  void check(SignalDeclaration& signal);
  void check(Pulse& pulse);
  void check(Simulate& simulation);
  /// Takes over a signal that an earlier entry of the prompt has declared.
  void know(const KeptName& kept, const Symbol& symbol);

 private:
  const Symbol* resolve(Name& name, Place place);
  void check_group(const SignalDeclaration& signal, const Symbol& first, Symbol& symbol);
  void check_digital(const SignalDeclaration& signal, const Symbol& channel);
  void check_analog(const SignalDeclaration& signal, Symbol& symbol);
  void check_scale(const SignalDeclaration& signal, Symbol& symbol);
  std::optional<double> constant_end(const Expr& end);
  void check_safe(SignalDeclaration& signal, const Symbol& symbol);
  std::optional<double> safe_value(const Expr& safe, const Symbol& symbol);
  bool is_device(std::string_view name) const;
  void check_device(Simulate& simulation);
  void check_operator(const Simulate& simulation);
  void check_input(Simulate& simulation, const Symbol& symbol);
  void check_force(Simulate& simulation, const Symbol& symbol);

  Scopes& scopes_;
  Declarations& declarations_;
  Names& names_;
  ExpressionChecker& expressions_;
  ValueChecker& values_;
  Diagnostics& diagnostics_;
  std::map<int, Place> safe_lines_;  ///< where a signal's SAFE value stands, by its number
};

}  // namespace rob::lang
