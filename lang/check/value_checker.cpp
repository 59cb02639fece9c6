#include "lang/check/value_checker.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/core.h>

#include "lang/check/meaning.h"
#include "lang/syntax/named_types.h"
#include "lang/text/codes.h"
#include "lang/values/file_name.h"
#include "lang/values/units.h"

namespace rob::lang {

std::string frame_in_words(const Type& pose) { return fmt::format("IN {}", frame_name(pose)); }

std::string as_written(const Type& type) {
  if (type.is(Type::Kind::Record)) return type.detail->name;
  if (type.is(Type::Kind::Array)) {
    return type.is_open() ? "ARRAY OF " + as_written(type.detail->element)
                          : fmt::format("ARRAY[{}] OF {}", type.detail->length,
                                        as_written(type.detail->element));
  }
  if (type.is(Type::Kind::Pose) && type.detail != nullptr) return "POSE " + frame_in_words(type);
  for (const NamedType& named : named_types()) {
    const bool joints = type.is(Type::Kind::Joints) && named.type.is(Type::Kind::Joints);
    if (joints || named.type == type) return std::string(named.name);
  }
  if (type.is(Type::Kind::List)) return "LIST OF " + as_written(type.detail->element);
  if (type.is(Type::Kind::Enum)) return type.detail->name;
  if (type.is(Type::Kind::Vec)) return "VEC OF " + as_written(Type::real(type.dimension));
  return fmt::format("[{}]", unit_text(type.dimension));
}

std::string not_as_written(const Type& given, const Type& wanted) {
  return fmt::format(" ({}, not {})", as_written(given), as_written(wanted));
}

std::string place_text(const Expr& place) {
  if (const auto* const name = std::get_if<Name>(&place.node)) return name->text;
  if (const auto* const member = std::get_if<Member>(&place.node))
    return fmt::format("{}.{}", place_text(*member->object), member->field);
  if (const auto* const index = std::get_if<Index>(&place.node))
    return place_text(*index->object) + "[…]";
  return "this";
}

std::string described(const Expr& expression) {
  const std::string words = in_words(expression.type);
  // A long text would bury the message.
  if (!known(expression.constant) || expression.type.kind == Type::Kind::String) return words;
  return words + ", " + text_of(expression.constant, expression.type);
}

Type common_type(const Type& a, const Type& b) {
  if (!a.known()) return b;
  if (!b.known() || a == b) return a;
  if (a.numeric() && b.numeric() && a.dimension == b.dimension) return Type::real(a.dimension);
  return {};
}

std::string_view symbol_of(BinaryOp op) {
  switch (op) {
    case BinaryOp::Or:
      return "OR";
    case BinaryOp::Xor:
      return "XOR";
    case BinaryOp::And:
      return "AND";
    case BinaryOp::Equal:
      return "==";
    case BinaryOp::NotEqual:
      return "<>";
    case BinaryOp::Less:
      return "<";
    case BinaryOp::LessEqual:
      return "<=";
    case BinaryOp::Greater:
      return ">";
    case BinaryOp::GreaterEqual:
      return ">=";
    case BinaryOp::Add:
      return "+";
    case BinaryOp::Subtract:
      return "-";
    case BinaryOp::Multiply:
      return "*";
    case BinaryOp::Divide:
      return "/";
    case BinaryOp::Div:
      return "DIV";
    case BinaryOp::Mod:
      return "MOD";
    case BinaryOp::Power:
      return "^";
    case BinaryOp::BitAnd:
      return "BITAND";
    case BinaryOp::BitOr:
      return "BITOR";
    case BinaryOp::BitXor:
      return "BITXOR";
    case BinaryOp::ShiftLeft:
      return "SHL";
    case BinaryOp::ShiftRight:
      return "SHR";
  }
  return {};
}

bool ValueChecker::accept(const Expr& expression, const Type& wanted, std::string_view needed) {
  const Type& type = expression.type;
  if (type.kind == Type::Kind::Unknown || wanted.kind == Type::Kind::Unknown) return true;
  if (refuse_open(expression)) return false;
  const bool literal = std::holds_alternative<List>(expression.node);
  if (literal && wanted.is(Type::Kind::List) && type.is(Type::Kind::List)) return true;
  if (type == wanted || (type == Type::integer() && wanted == Type::real())) return true;
  if (type.is_place() && wanted.is_place()) {
    if (fits_place(expression, wanted)) return true;
    diagnostics_.error(
        code::kFrames, expression.place,
        fmt::format("this is {}; {} {} here", described(expression), needed, in_words(wanted)),
        wanted.is(Type::Kind::Pose)
            ? fmt::format("TO_FRAME(p, {}) gives the same place there", frame_name(wanted))
            : "");
    return false;
  }
  if (const auto* const list = std::get_if<List>(&expression.node); list != nullptr) {
    if (wanted.is(Type::Kind::List)) return accept_elements(*list, wanted, needed);
    if (refuse_empty(expression)) return false;
    if (wanted.is(Type::Kind::Array)) return accept_list(expression, *list, wanted, needed);
  }
  std::string help;
  if (wanted == Type::integer() && type == Type::real()) {
    help = "ROUND, TRUNC, FLOOR and CEIL make a whole number of it";
  } else if (is_bare(type) && wanted.numeric()) {
    help = "write the unit, for example " + example_of(wanted.dimension);
  } else if (wanted == Type::boolean() && type.numeric()) {
    help = "use TRUE or FALSE, ON or OFF";
  } else if (wanted == Type::string()) {
    help = "STR(x) makes a text of any value";
  }
  const bool quantities = type.numeric() && wanted.numeric() && type.dimension != wanted.dimension;
  diagnostics_.error(quantities ? code::kDimensionMismatch : code::kTypeMismatch, expression.place,
                     fmt::format("this is {}; {} {} here{}", described(expression), needed,
                                 in_words(wanted), not_as_written(type, wanted)),
                     help);
  return false;
}

bool ValueChecker::refuse_open(const Expr& expression) {
  if (!expression.type.is_open()) return false;
  diagnostics_.error(code::kOpenArray, expression.place,
                     "an ARRAY of any length is given to REF parameters alone: it is neither "
                     "copied nor compared as a whole",
                     "go through its elements: FOR x IN a DO");
  return true;
}

bool ValueChecker::refuse_empty(const Expr& expression) {
  const auto* const list = std::get_if<List>(&expression.node);
  if (list == nullptr || !list->elements.empty()) return false;
  diagnostics_.error(
      code::kListEmpty, expression.place, "there is nothing between the brackets",
      "an ARRAY has at least one element; a LIST needs its type: VAR l: LIST OF INT");
  return true;
}

bool ValueChecker::accept_elements(const List& list, const Type& wanted, std::string_view needed) {
  return std::ranges::all_of(list.elements, [&](const ExprPtr& element) {
    return accept(*element, wanted.detail->element, needed);
  });
}

/// A list takes the type that is wanted, element by element.
bool ValueChecker::accept_list(const Expr& expression, const List& list, const Type& wanted,
                               std::string_view needed) {
  const auto count = static_cast<std::int64_t>(list.elements.size());
  if (wanted.detail->length != 0 && count != wanted.detail->length) {
    diagnostics_.error(
        code::kTypeMismatch, expression.place,
        fmt::format("the length of this list is {}; {} {}", count, needed, wanted.detail->length));
    return false;
  }
  return accept_elements(list, wanted, needed);
}

/// Whether a place may stand where another kind of place is wanted; a pose in a frame is brought
/// to the world where that is wanted.
bool ValueChecker::fits_place(const Expr& expression, const Type& wanted) const {
  const Type pose = as_pose(expression.type);
  const Slots slots = slots_of(wanted);
  if (slots != slots_of(expression.type)) expression.place_slots = slots.numbers;
  if (is_free(pose) || (wanted.is(Type::Kind::Pose) && pose == wanted)) return true;
  if (wanted.is(Type::Kind::Pose) && wanted != Type::pose()) return false;
  if (wanted.is(Type::Kind::Tool)) return pose == Type::pose();
  if (pose == Type::pose()) return true;
  expression.moved_from = frame_of(pose);
  return expression.moved_from != nullptr;
}

/// A FRAME of any file, where it is declared already.
const Symbol* ValueChecker::frame_of(const Type& pose) const {
  if (!pose.is(Type::Kind::Pose) || pose.detail == nullptr || is_free(pose)) return nullptr;
  return scopes_.frame_of(pose.detail);
}

bool ValueChecker::require_positive(const Expr& value, std::string_view word) {
  const auto number = constant_number(value);
  if (!number || *number > 0) return true;
  diagnostics_.error(
      code::kNotPositive, value.place,
      fmt::format("{} needs a value above zero; this is {}", word, described(value)));
  return false;
}

void ValueChecker::require_time(const Expr& time, std::string_view word) {
  const auto number = constant_number(time);
  if (!number || *number >= 0) return;
  diagnostics_.error(
      code::kNegativeTime, time.place,
      fmt::format("{} needs a time of 0s or more; this is {}", word, described(time)));
}

void ValueChecker::check_file(const ExprPtr& name, std::string_view word) {
  const auto* const text = name == nullptr ? nullptr : std::get_if<std::string>(&name->constant);
  if (text == nullptr) return;
  const std::string objection = objection_to_file(*text);
  if (objection.empty()) return;
  diagnostics_.error(code::kFileName, name->place,
                     fmt::format("{} cannot use '{}': {}", word, shortened(*text), objection),
                     "a program has the files of its own folder, such as \"log.csv\"");
}

Type ValueChecker::bounded(Dimension d, const Expr& expression) {
  // [choice] physics needs 4 at most; 16 leaves room for intermediate results, and products of two
  // such dimensions are still far from the range of the exponents.
  constexpr int kMostExponent = 16;
  for (const int exponent : {d.length, d.mass, d.time, d.angle, d.voltage}) {
    if (std::abs(exponent) <= kMostExponent) continue;
    diagnostics_.error(
        code::kDimensionTooHigh, expression.place,
        fmt::format("this would be {}; exponents of units end at {}", in_words(d), kMostExponent));
    return {};
  }
  return Type::real(d);
}

Type ValueChecker::common_frame(const Expr& left, const Expr& right, std::string_view what) {
  const Type a = as_pose(left.type);
  const Type b = as_pose(right.type);
  if (is_free(a)) return b;
  if (is_free(b) || a == b) return a;
  diagnostics_.error(code::kFrames, right.place,
                     fmt::format("{} needs poses in one frame; these are {} and {}", what,
                                 frame_in_words(a), frame_in_words(b)),
                     "TO_FRAME(p, f) gives the same place in another frame");
  return {};
}

void ValueChecker::keep(const Folded& folded, Expr& expression) {
  if (folded.error == ArithmeticError::None) {
    expression.constant = folded.value;
  } else if (reached()) {
    const ArithmeticErrorText text = describe(folded.error);
    diagnostics_.error(text.code, expression.place, std::string(text.message),
                       std::string(text.help));
  }
}

}  // namespace rob::lang
