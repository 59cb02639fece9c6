#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "lang/check/declared_elsewhere.h"
#include "lang/check/expression_checker.h"
#include "lang/check/routine.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"

/// Member functions of ExpressionChecker for arrays: their types, lists and lengths. They also
/// check where the type of a record may be used.
namespace rob::lang {
namespace {

std::optional<std::string> too_large(Slots element, std::int64_t count) {
  const auto beyond = [count](int slots, int most) {
    return slots > 0 && count > static_cast<std::int64_t>(most / slots);
  };
  if (beyond(element.numbers, kMemory.numbers)) {
    return fmt::format("a program has room for {} numbers in arrays and records", kMemory.numbers);
  }
  if (beyond(element.texts, kMemory.texts)) {
    return fmt::format("a program has room for {} texts in arrays and records", kMemory.texts);
  }
  return std::nullopt;
}

}  // namespace

bool ExpressionChecker::fits_memory(const Type& element, std::int64_t count, Place place) {
  const auto why = too_large(slots_of(element), count);
  if (!why) return true;
  diagnostics_.error(
      code::kArrayTooLarge, place,
      fmt::format("{} elements are too many, each {}: {}", count, in_words(element), *why),
      "keep less at once");
  return false;
}

bool ExpressionChecker::complete(const Type& type, Place place) {
  if (type.is(Type::Kind::Record) && !type.detail->complete) {
    const auto declared = find_declaration(program_, type.detail->name, place.file);
    diagnostics_.error(
        code::kUnknownName, place,
        fmt::format("the record {} is not known here", shortened(type.detail->name)),
        declared
            ? fmt::format("it is declared in line {}: declare it before using it", declared->line)
            : "");
    return false;
  }
  if (!type.is(Type::Kind::Array)) return true;
  const bool sound = complete(type.detail->element, place);
  if (type.detail->written < 0) return sound;
  auto& written = program_.array_lengths[static_cast<std::size_t>(type.detail->written)];
  if (!written.settled) {
    written.settled = true;
    if (sound) settle_length(written);
  }
  return type.detail->length > 0;
}

void ExpressionChecker::settle_length(Program::ArrayLength& written) {
  const Type type = check(written.length);
  if (!type.known()) return;
  const auto* const number = std::get_if<std::int64_t>(&written.length->constant);
  if (number == nullptr || *number < 1) {
    diagnostics_.error(code::kArrayLength, written.length->place,
                       fmt::format("the length of an ARRAY is a constant whole number above 0; "
                                   "this is {}",
                                   described(*written.length)),
                       number == nullptr ? "declare it with CONST" : "");
    return;
  }
  TypeDetail& array = *written.array;
  if (!fits_memory(array.element, *number, written.place)) return;
  const Slots size = slots_of(array.element);
  array.length = *number;
  array.height = height_of(array.element) + 1;
  const auto count = static_cast<int>(*number);
  array.slots = {.numbers = size.numbers * count, .texts = size.texts * count};
}

/// Types in the head of a routine are read where it is first called, or where it stands: what is
/// declared at the top level by then may be used.
void ExpressionChecker::complete_header(const Routine& routine) {
  Routine& header = program_.routines[routine.index];
  scopes_.look_from_top(true);
  for (Routine::Parameters& group : header.parameters) {
    if (!complete(group.type, group.names.front().place)) group.type = Type{};
  }
  if (!complete(header.result, header.name_place)) header.result = Type{};
  scopes_.look_from_top(false);
}

/// The type of an element that both can be; Unknown if there is none.
Type ExpressionChecker::element_type(const Type& a, const Type& b) {
  if (a.is_place() && b.is_place()) {
    const Type pose = as_pose(b);
    if (is_free(a)) return pose;
    return is_free(pose) || pose == a ? a : Type{};
  }
  if (a.is(Type::Kind::Array) && b.is(Type::Kind::Array) && a != b &&
      a.detail->length == b.detail->length) {
    const Type element = element_type(a.detail->element, b.detail->element);
    return element.known() ? program_.types->array(element, a.detail->length) : Type{};
  }
  return a == b ? a : common_type(a, b);
}

Type ExpressionChecker::check(List& list, Expr& expression) {
  bool sound = true;
  for (const ExprPtr& element : list.elements) sound = check(element).known() && sound;
  if (!sound) return {};
  Type common = as_pose(list.elements.front()->type);
  for (const ExprPtr& element : list.elements) {
    const Type next = element_type(common, element->type);
    if (!next.known()) {
      diagnostics_.error(
          code::kListMixed, element->place,
          fmt::format("this is {}; the list began with {}", described(*element), in_words(common)),
          "all elements of an ARRAY are of one type");
      return {};
    }
    common = next;
  }
  common = settled(common);
  const auto count = static_cast<std::int64_t>(list.elements.size());
  for (const ExprPtr& element : list.elements) {
    if (!accept(*element, common, "the list needs")) return {};
  }
  if (!fits_memory(common, count, expression.place)) return {};
  return program_.types->array(common, count);
}

/// A list takes the type that is wanted, element by element.
bool ExpressionChecker::accept_list(const Expr& expression, const List& list, const Type& wanted,
                                    std::string_view needed) {
  const auto count = static_cast<std::int64_t>(list.elements.size());
  if (wanted.detail->length != 0 && count != wanted.detail->length) {
    diagnostics_.error(
        code::kTypeMismatch, expression.place,
        fmt::format("the length of this list is {}; {} {}", count, needed, wanted.detail->length));
    return false;
  }
  return std::ranges::all_of(list.elements, [&](const ExprPtr& element) {
    return accept(*element, wanted.detail->element, needed);
  });
}

/// LEN(a): known from the type, unless a routine must be called for a.
void ExpressionChecker::fold_length(const Call& call, Expr& expression) {
  const Expr& array = *call.arguments.front();
  if (!calls_routine(array)) expression.constant = array.type.detail->length;
}

}  // namespace rob::lang
