#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "lang/text/diagnostic.h"
#include "lang/values/types.h"

/// The expressions of the syntax tree (lang/syntax/ast.h).
namespace rob::lang {

struct Expr;
struct Symbol;
struct Routine;
using ExprPtr = std::unique_ptr<Expr>;

/// `10`, `0.5`, `20mm`: the quantity (units.h). Its dimension is its unit's.
struct NumberLiteral {
  double value = 0;
  /// The value where is_integer. The least INT, below 0, is that of 9223372036854775808, which
  /// needs a '-' directly before it.
  std::int64_t integer = 0;
  bool is_integer = false;  ///< written without point, exponent or unit
  Dimension dimension;
  bool has_unit = false;  ///< written with a unit: distinguishes 50% from 0.5, both dimensionless
};
struct BoolLiteral {
  bool value = false;
};
struct StringLiteral {
  std::string value;
};
/// A variable, constant, signal or built-in value; DIN[n], DOUT[n], AIN[n], AOUT[n] have an index.
struct Name {
  std::string text;
  const Symbol* symbol = nullptr;  ///< set by the checker; owned by the CheckedProgram
  ExprPtr index = nullptr;
};

enum class UnaryOp : std::uint8_t { Negate, Plus, Not, BitNot };
struct Unary {
  UnaryOp op;
  ExprPtr operand;
};

enum class BinaryOp : std::uint8_t {
  Or,
  Xor,
  And,
  Equal,
  NotEqual,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  Add,
  Subtract,
  Multiply,
  Divide,
  Div,
  Mod,
  Power,
  BitAnd,
  BitOr,
  BitXor,
  ShiftLeft,
  ShiftRight
};
struct Binary {
  BinaryOp op;
  ExprPtr left;
  ExprPtr right;
};

/// `MAX(a, b)`, `place(part, above: 20mm)`: a built-in function or a routine of the program.
struct Call {
  std::string callee;
  std::vector<ExprPtr> arguments;
  std::vector<std::string> names;    ///< of the arguments; empty where one was not named
  std::vector<bool> references{};    ///< of the arguments: REF stands before one
  const Routine* routine = nullptr;  ///< set by the checker; null for a built-in function
  /// Of a routine, set by the checker: one a parameter; of a record one a field, null where its
  /// default stands in.
  std::vector<const Expr*> bound{};
  const TypeDetail* record = nullptr;  ///< that is built; set by the checker
};

/// `(140, , )` or `(x: 140mm)`. One unnamed element in parentheses is a group, not a tuple.
struct Tuple {
  struct Element {
    std::string name;  ///< empty where it was not named
    ExprPtr value;     ///< null where it was left out
    Place place;
  };
  std::vector<Element> elements;
};

/// `v.x`, `part.size`.
struct Member {
  ExprPtr object;
  std::string field;
  Place field_place;
};

/// `a[i]`, `v[2]`.
struct Index {
  ExprPtr object;
  ExprPtr index;
};

/// `[1mm, 2mm]`: an ARRAY.
struct List {
  std::vector<ExprPtr> elements;
};

/// A sum, or texts joined, of very many terms, from left to right: what is long need not be deep.
struct Chain {
  struct Step {
    BinaryOp op;
    Place place;  ///< of the sign
    ExprPtr term;
    Type type{};  ///< of the sum up to here; set by the checker
  };
  ExprPtr first;
  std::vector<Step> steps;
};

/// Any constant expression's value; settled by the checker. The last is the slots of a compound
/// value of nothing but REALs. Arrays and records have none: they are computed where they stand.
using Constant =
    std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>>;

struct Expr {
  Place place;  ///< of the token a message should point at
  std::variant<NumberLiteral, BoolLiteral, StringLiteral, Name, Unary, Binary, Call, Tuple, Member,
               Index, List, Chain>
      node;
  Type type;  ///< set by the checker
  /// Set by the checker: a pose in this FRAME that stands where one in the world is wanted.
  mutable const Symbol* moved_from = nullptr;
  /// Set by the checker: a pose that stands where a TOOL is wanted, or the other way round.
  /// Slots that it is to have; 0: those of its type.
  mutable int place_slots = 0;
  Constant constant;  ///< set by the checker where the value is known before the program runs
  int height =
      1;  ///< levels of this tree; the parser keeps it at kMaxDepth (syntax_limits.h) at most
};

/// The variable that an assignable place is part of: `a` of `a[i].x`; null where it is none.
inline const Name* root_of(const Expr& place) {
  const Expr* at = &place;
  for (;;) {
    if (const auto* const member = std::get_if<Member>(&at->node)) {
      at = member->object.get();
    } else if (const auto* const index = std::get_if<Index>(&at->node)) {
      at = index->object.get();
    } else {
      return std::get_if<Name>(&at->node);
    }
  }
}

}  // namespace rob::lang
