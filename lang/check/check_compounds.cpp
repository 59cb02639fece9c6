#include <string>

#include <fmt/format.h>

#include "lang/check/expression_checker.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/values/number_text.h"

/// Member functions of ExpressionChecker for values of several parts: how they are written, their
/// fields and their elements.
namespace rob::lang {
namespace {

/// The known value of a part, from the known value of the whole.
Constant part_of(const Constant& whole, const Type& type, int offset) {
  const auto* const slots = std::get_if<std::vector<double>>(&whole);
  if (slots == nullptr) return {};
  if (type.is(Type::Kind::Real)) return slots->at(static_cast<std::size_t>(offset));
  const auto begin = slots->begin() + offset;
  return std::vector<double>(begin, begin + slots_of(type).numbers);
}

}  // namespace

/// Outside of a motion a tuple is a VEC.
Type ExpressionChecker::check(const Tuple& tuple, Expr& expression) {
  Type common;
  bool sound = true;
  bool complete = tuple.elements.size() == 3;
  std::vector<double> slots;
  for (const Tuple::Element& element : tuple.elements) {
    complete = complete && element.value != nullptr && element.name.empty();
    const Type type = check(element.value);
    sound = sound && type.known();
    if (!sound || !complete) continue;
    common = common_type(common, type);
    complete = common.numeric();
    const Constant value = converted(element.value->constant, Type::real());
    if (const double* const real = std::get_if<double>(&value)) slots.push_back(*real);
  }
  if (!complete) {
    diagnostics_.error(
        code::kTupleMisplaced, expression.place,
        "outside of a motion, values in parentheses are a VEC: three of one dimension",
        "a target of a motion stands behind MOVE itself");
    return {};
  }
  if (!sound) return {};
  if (slots.size() == 3) expression.constant = std::move(slots);
  return Type::vec(common.dimension);
}

Type ExpressionChecker::check(Member& member, Expr& expression) {
  const Type whole = check(member.object);
  if (!whole.known()) return {};
  if (const auto angle = angle_of(whole, member.field)) {
    return check_angle(member, *angle, expression);
  }
  const auto field = field_of(whole, member.field);
  if (!field) {
    if (whole.is(Type::Kind::Record) && whole.detail->faulty) return {};
    const auto names = field_names(whole);
    std::string help = did_you_mean(suggest(member.field, names));
    if (help.empty() && !names.empty()) help = fmt::format("it has {}", fmt::join(names, ", "));
    diagnostics_.error(
        code::kNoSuchField, member.field_place,
        fmt::format("this is {}, which has no field {}", in_words(whole), shortened(member.field)),
        help);
    return {};
  }
  expression.constant = part_of(member.object->constant, field->type, field->offset.numbers);
  return field->type;
}

Type ExpressionChecker::check(Index& index, Expr& expression) {
  const Type whole = check(index.object);
  const Type place = check(index.index);
  if (!whole.known()) return {};
  const auto elements = elements_of(whole);
  if (!elements) {
    diagnostics_.error(code::kNoElements, expression.place,
                       fmt::format("this is {}, which has no elements", described(*index.object)));
    return {};
  }
  if (!place.known() || !accept(*index.index, Type::integer(), "an index needs")) {
    return whole.is(Type::Kind::Joints) ? Type{} : elements->type;
  }
  const Type element = whole.is(Type::Kind::Joints) ? axis_type(index, whole) : elements->type;
  const auto* const number = std::get_if<std::int64_t>(&index.index->constant);
  if (number == nullptr || elements->count == 0) return element;
  if (*number >= 1 && *number <= elements->count) {
    const int size = slots_of(elements->type).numbers;
    expression.constant =
        part_of(index.object->constant, element, static_cast<int>(*number - 1) * size);
  } else if (reached()) {
    diagnostics_.error(code::kIndexBeyond, index.index->place,
                       fmt::format("there is no element {}: this is {}", *number, in_words(whole)),
                       fmt::format("elements count from 1 to {}", elements->count));
  }
  return element;
}

}  // namespace rob::lang
