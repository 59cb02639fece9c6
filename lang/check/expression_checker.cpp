#include "lang/check/expression_checker.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/values/pose_functions.h"

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

/// p.a, p.b, p.c: computed, since they do not lie in the pose.
Type check_angle(const Member& member, int which, Expr& expression) {
  if (known(member.object->constant)) {
    Slot angle{};
    pose_functions::angle(to_slots(member.object->constant).data(), which, angle);
    expression.constant = angle.real;
  }
  return Type::real(kAngle);
}

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

/// Whether it has a LIST that is no global, or turns a literal into one to compare it.
bool makes_list(const Expr& expression) {
  if (const auto* const binary = std::get_if<Binary>(&expression.node)) {
    const auto literal = [](const Expr& side, const Expr& other) {
      return std::holds_alternative<List>(side.node) && other.type.is(Type::Kind::List);
    };
    return binary->left != nullptr && binary->right != nullptr &&
           (literal(*binary->left, *binary->right) || literal(*binary->right, *binary->left));
  }
  const auto* const name = std::get_if<Name>(&expression.node);
  const bool global = name != nullptr && name->symbol != nullptr && name->symbol->global;
  return expression.type.is(Type::Kind::List) && !global;
}

}  // namespace

Type ExpressionChecker::check(const ExprPtr& expression) {
  if (expression == nullptr) return {};
  expression->type =
      std::visit([&](auto& node) { return check(node, *expression); }, expression->node);
  memory_use_ = memory_use_ || !expression->type.in_registers();
  if (makes_list(*expression)) uses_.met_list(expression->place);
  return expression->type;
}

void ExpressionChecker::check_statement(const ExprPtr& call) {
  statement_ = call.get();
  check(call);
  statement_ = nullptr;
}

void ExpressionChecker::check_condition(const ExprPtr& condition, std::string_view word) {
  const Type type = check(condition);
  if (type.kind == Type::Kind::Unknown || type == Type::boolean()) return;
  std::string help = "compare it, for example x > 0";
  if (known(condition->constant)) {
    help = word == "WHILE" ? "write WHILE TRUE"
                           : fmt::format("compare something, or name a signal: {} part_here", word);
  }
  if (type == Type::string()) help = "compare it, for example s == \"done\"";
  diagnostics_.error(
      code::kConditionExpected, condition->place,
      fmt::format("{} needs a condition here; this is {}", word, described(*condition)), help);
}

bool ExpressionChecker::check_as(const ExprPtr& expression, const Type& wanted,
                                 std::string_view needed) {
  check(expression);
  return expression != nullptr && values_.accept(*expression, wanted, needed);
}

Type ExpressionChecker::check_fixed(const ExprPtr& expression, bool& missed) {
  fixed_ = true;
  missed_ = false;
  const Type type = check(expression);
  fixed_ = false;
  missed = missed_;
  return type;
}

const Symbol* ExpressionChecker::resolve_channel(Name& name, Place place) {
  return check(name.index).known() ? names_.resolve_channel(name, place) : nullptr;
}

Type ExpressionChecker::check(const BoolLiteral& literal, Expr& expression) {
  expression.constant = literal.value;
  return Type::boolean();
}

Type ExpressionChecker::check(const StringLiteral& literal, Expr& expression) {
  expression.constant = literal.value;
  return Type::string();
}

Type ExpressionChecker::check(const NumberLiteral& literal, Expr& expression) {
  if (literal.is_integer) {
    expression.constant = literal.integer;
    return Type::integer();
  }
  expression.constant = literal.value;
  return Type::real(literal.dimension);
}

Type ExpressionChecker::check(Name& name, Expr& expression) {
  name.symbol = name.index != nullptr ? resolve_channel(name, expression.place)
                                      : names_.resolve(name.text, expression.place);
  if (name.symbol == nullptr) return {};
  if (name.symbol->kind == Symbol::Kind::Reading &&
      !has_sensor(name.symbol->reading, expression.place)) {
    return {};
  }
  if (name.symbol->kind == Symbol::Kind::Point) missing_.use(*name.symbol);
  const bool reading =
      name.symbol->kind == Symbol::Kind::Reading && is_observation(name.symbol->reading);
  if (reading || name.symbol->kind == Symbol::Kind::Signal) uses_.met_robot(expression.place);
  const bool frozen = fixed_ && name.symbol->kind == Symbol::Kind::Point;
  expression.constant = frozen ? name.symbol->kept : name.symbol->value;
  missed_ = missed_ || (frozen && !known(expression.constant));
  return name.symbol->type;
}

Type ExpressionChecker::check(Unary& unary, Expr& expression) {
  check(unary.operand);
  return operators_.check(unary, expression);
}

Type ExpressionChecker::check(Binary& binary, Expr& expression) {
  if (binary.op <= BinaryOp::And) return check_logical(binary, expression);
  check(binary.left);
  check(binary.right);
  return operators_.check(binary, expression);
}

/// Each step is a Binary of what stands for the sum so far, and of the next term.
Type ExpressionChecker::check(Chain& chain, Expr& expression) {
  auto sum = std::make_unique<Expr>();
  sum->type = check(chain.first);
  sum->place = chain.first->place;
  sum->constant = chain.first->constant;
  for (Chain::Step& step : chain.steps) {
    check(step.term);
    Expr next;
    next.place = step.place;
    next.node = Binary{step.op, std::move(sum), std::move(step.term)};
    auto& binary = std::get<Binary>(next.node);
    step.type = operators_.check(binary, next);
    step.term = std::move(binary.right);
    sum = std::move(binary.left);
    sum->type = step.type;
    sum->constant = std::move(next.constant);
    if (step.type.known() && !step.type.numeric() && !step.type.text()) {
      diagnostics_.error(code::kTooDeep, step.place,
                         "only sums of numbers, and texts that are joined, are that long",
                         "compute parts of it before, in variables");
      return {};
    }
  }
  expression.constant = sum->constant;
  return sum->type;
}

/// The right side of AND is not executed where the left is FALSE, that of OR where it is TRUE.
Type ExpressionChecker::check_logical(Binary& binary, Expr& expression) {
  const auto check_side = [&](const ExprPtr& side) {
    const Type type = check(side);
    if (!type.known() || type == Type::boolean()) return true;
    diagnostics_.error(code::kTypeMismatch, side->place,
                       fmt::format("{} needs TRUE or FALSE on both sides; this is {}",
                                   symbol_of(binary.op), described(*side)),
                       type.numeric() ? "compare it, for example x > 0" : "");
    return false;
  };
  bool sound = check_side(binary.left);
  const bool* const settled = std::get_if<bool>(&binary.left->constant);
  const bool skipped =
      settled != nullptr && binary.op != BinaryOp::Xor && *settled == (binary.op == BinaryOp::Or);
  if (skipped) values_.enter_unreached();
  sound = check_side(binary.right) && sound;
  if (skipped) values_.leave_unreached();
  if (sound) {
    values_.keep(fold(binary.op, binary.left->constant, binary.right->constant, Type::boolean()),
                 expression);
  }
  return Type::boolean();
}

Type ExpressionChecker::check(Call& call, Expr& expression) {
  bool sound = true;
  for (const ExprPtr& argument : call.arguments) {
    sound = check(argument).kind != Type::Kind::Unknown && sound;
  }
  if (names_.report_ambiguous(call.callee, expression.place)) return {};
  const bool statement = &expression == statement_;
  const Symbol* const symbol = names_.find(call.callee);
  if (symbol != nullptr && symbol->kind == Symbol::Kind::Record) {
    return calls_.check_record(call, expression.place, symbol->type, statement);
  }
  if (symbol != nullptr && symbol->kind == Symbol::Kind::Routine) {
    const Routine& routine = *symbol->routine;
    call.routine = &routine;
    uses_.called(routine, expression.place);
    if (!routine.task) complete_header(routine);
    return calls_.check_routine(call, expression.place, routine, statement);
  }
  const Builtin* const builtin = names_.resolve_function(call, expression.place);
  if (builtin == nullptr) return {};
  if (builtins_.stands_wrong(*builtin, call, statement, expression.place)) return {};
  if (reading_of(call)) uses_.met_robot(expression.place);
  return builtins_.check(*builtin, call, sound, expression);
}

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
        "a target of a motion stands after MOVE itself");
    return {};
  }
  if (!sound) return {};
  if (slots.size() == 3) expression.constant = std::move(slots);
  return Type::vec(common.dimension);
}

Type ExpressionChecker::check_enumerator(Member& member, Name& name, Expr& expression) {
  if (names_.report_ambiguous(name.text, member.object->place)) return {};
  const Symbol& symbol = *names_.find(name.text);
  const TypeDetail& detail = *symbol.type.detail;
  const auto value = value_of(detail, member.field);
  if (value) {
    name.symbol = &symbol;
    expression.constant = *value;
    return symbol.type;
  }
  if (detail.faulty) return {};
  const std::vector<std::string_view> names(detail.names.begin(), detail.names.end());
  std::string help = did_you_mean(suggest(member.field, names));
  if (help.empty()) help = fmt::format("it has {}", fmt::join(names, ", "));
  diagnostics_.error(
      code::kNoSuchField, member.field_place,
      fmt::format("the ENUM {} has no {}", shortened(detail.name), shortened(member.field)), help);
  return {};
}

Type ExpressionChecker::check(Member& member, Expr& expression) {
  if (auto* const name = std::get_if<Name>(&member.object->node)) {
    const Symbol* const symbol = names_.find(name->text);
    if (symbol != nullptr && symbol->kind == Symbol::Kind::Enum) {
      return check_enumerator(member, *name, expression);
    }
  }
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
  if (!place.known() || !values_.accept(*index.index, Type::integer(), "an index needs")) {
    return whole.is(Type::Kind::Joints) ? Type{} : elements->type;
  }
  const Type element = whole.is(Type::Kind::Joints) ? builtins_.axis_type(index) : elements->type;
  const auto* const number = std::get_if<std::int64_t>(&index.index->constant);
  if (number == nullptr || elements->count <= 0) return element;
  if (*number >= 1 && *number <= elements->count) {
    const int size = slots_of(elements->type).numbers;
    expression.constant =
        part_of(index.object->constant, element, static_cast<int>(*number - 1) * size);
  } else if (values_.reached()) {
    diagnostics_.error(code::kIndexBeyond, index.index->place,
                       fmt::format("there is no element {}: this is {}", *number, in_words(whole)),
                       fmt::format("elements count from 1 to {}", elements->count));
  }
  return element;
}

Type ExpressionChecker::check(List& list, Expr& expression) {
  if (list.elements.empty()) return program_.types->list(Type{});
  bool sound = true;
  for (const ExprPtr& element : list.elements) sound = check(element).known() && sound;
  if (!sound) return {};
  if (list.elements.front()->type.is(Type::Kind::List)) {
    refuse_list_inside(list.elements.front()->place);
    return {};
  }
  Type common = as_pose(list.elements.front()->type);
  for (const ExprPtr& element : list.elements) {
    const Type next = element_type(common, element->type);
    if (!next.known()) {
      diagnostics_.error(code::kListMixed, element->place,
                         fmt::format("this is {}; the list began with {}{}", described(*element),
                                     in_words(common), not_as_written(element->type, common)),
                         "all elements of an ARRAY are of one type");
      return {};
    }
    common = next;
  }
  common = settled(common);
  if (values_.refuse_open(*list.elements.front())) return {};
  const auto count = static_cast<std::int64_t>(list.elements.size());
  for (const ExprPtr& element : list.elements) {
    if (!values_.accept(*element, common, "the list needs")) return {};
  }
  if (!fits_memory(common, count, expression.place)) return {};
  return program_.types->array(common, count);
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
  if ((type.is(Type::Kind::Record) || type.is(Type::Kind::Enum)) && !type.detail->complete) {
    const auto declared = names_.declaration_of(type.detail->name, place.file);
    diagnostics_.error(
        code::kUnknownName, place,
        fmt::format("the {} {} is not known here", type.is(Type::Kind::Enum) ? "ENUM" : "record",
                    shortened(type.detail->name)),
        declared
            ? fmt::format("it is declared in line {}: declare it before using it", declared->line)
            : "");
    return false;
  }
  if (!type.has_row()) return true;
  const TypeDetail& detail = *type.detail;  // a length that calls its own FUNC makes `type` unknown
  const bool sound = complete(detail.element, place);
  if (detail.element.is(Type::Kind::List)) {
    refuse_list_inside(place);
    return false;
  }
  if (type.is(Type::Kind::List)) return sound;
  if (type.is_open()) {
    diagnostics_.error(code::kOpenArray, place,
                       "only a REF parameter can be an ARRAY of any length",
                       "write the length, as in ARRAY[3] OF, or REF before the parameter");
    return false;
  }
  if (detail.written < 0) return sound;
  auto& written = program_.array_lengths[static_cast<std::size_t>(detail.written)];
  if (!written.settled) {
    written.settled = true;
    if (sound) settle_length(written);
  }
  return detail.length > 0;
}

void ExpressionChecker::refuse_list_inside(Place place) {
  diagnostics_.error(code::kListInside, place,
                     "a LIST is no part of an ARRAY, of a RECORD or of another LIST",
                     "an ARRAY has a place there; or keep several LISTs side by side");
}

void ExpressionChecker::settle_length(Program::ArrayLength& written) {
  const Type type = check(written.length);
  // A FUNC that its own head calls has no type yet, and nobody has reported that.
  if (!type.known() && (written.length == nullptr || !calls_routine(*written.length))) return;
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
    const bool open = group.by_reference && group.type.is_open();
    const Type& type = open ? group.type.detail->element : group.type;
    if (!complete(type, group.names.front().place)) group.type = Type{};
  }
  if (!complete(header.result, header.name_place)) header.result = Type{};
  scopes_.look_from_top(false);
}

}  // namespace rob::lang
