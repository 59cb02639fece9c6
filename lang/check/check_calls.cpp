#include <algorithm>
#include <array>
#include <string>

#include <fmt/core.h>

#include "lang/check/called_builtins.h"
#include "lang/check/expression_checker.h"
#include "lang/check/observations.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/values/units.h"

/// Member functions of ExpressionChecker for calls of built-in functions.
namespace rob::lang {
namespace {

/// Of all forms of the function: FLOOR(x) and FLOOR(x, step) make "1 to 2 arguments".
std::string count_of_arguments(const Builtin& builtin) {
  std::size_t least = builtin.least;
  std::size_t most = builtin.most;
  for (const Builtin& other : builtins()) {
    if (other.name != builtin.name) continue;
    least = std::min(least, other.least);
    most = std::max<std::size_t>(most, other.most);
  }
  if (most > least) return fmt::format("{} to {} arguments", least, most);
  return builtin.least == 1 ? "one argument" : fmt::format("{} arguments", builtin.least);
}

/// The exponents halved, or nothing if they are not even.
std::optional<Dimension> root_of(Dimension d) {
  const auto odd = [](std::int8_t exponent) { return exponent % 2 != 0; };
  if (odd(d.length) || odd(d.mass) || odd(d.time) || odd(d.angle) || odd(d.voltage)) {
    return std::nullopt;
  }
  const auto half = [](std::int8_t exponent) { return static_cast<std::int8_t>(exponent / 2); };
  return Dimension{.length = half(d.length),
                   .mass = half(d.mass),
                   .time = half(d.time),
                   .angle = half(d.angle),
                   .voltage = half(d.voltage)};
}

}  // namespace

Type ExpressionChecker::check(Call& call, Expr& expression) {
  bool sound = true;
  for (const ExprPtr& argument : call.arguments) {
    sound = check(argument).kind != Type::Kind::Unknown && sound;
  }
  if (report_ambiguous(call.callee, expression.place)) return {};
  if (const Symbol* const symbol = scopes_.find(call.callee);
      symbol != nullptr && symbol->kind == Symbol::Kind::Routine) {
    return check_routine_call(call, expression, *symbol->routine);
  } else if (symbol != nullptr && symbol->kind == Symbol::Kind::Record) {
    return check_record(call, expression, symbol->type);
  }
  const Builtin* const builtin = resolve_function(call, expression.place);
  if (builtin == nullptr) return {};
  if (&expression == statement_) {
    diagnostics_.error(code::kRoutineMisused, expression.place,
                       fmt::format("{} gives a value, which is not used here", builtin->name),
                       "a statement calls a PROC");
    return {};
  }
  if (reading_of(call)) uses_.met_robot(expression.place);
  if (builtin->rule == BuiltinRule::Joints) {
    return expression.type = sound ? check_joints(call, expression) : Type{};
  }
  for (const std::string& name : call.names) {
    if (name.empty()) continue;
    diagnostics_.error(code::kArgumentName, expression.place,
                       fmt::format("the arguments of {} have no names", builtin->name));
    return {};
  }
  if (call.arguments.size() < builtin->least || call.arguments.size() > builtin->most) {
    diagnostics_.error(code::kArgumentCount, expression.place,
                       fmt::format("{} needs {}; here are {}", builtin->name,
                                   count_of_arguments(*builtin), call.arguments.size()));
    return {};
  }
  if (!sound) return {};
  expression.type = check_arguments(*builtin, call, expression.place);
  if (expression.type.kind != Type::Kind::Unknown) fold_call(*builtin, call, expression);
  return expression.type;
}

const Builtin* ExpressionChecker::resolve_function(const Call& call, Place place) {
  if (scopes_.find(call.callee) != nullptr) {
    diagnostics_.error(code::kNotAFunction, place,
                       fmt::format("{} is a value, not a function", shortened(call.callee)),
                       find_builtin(call.callee, 0) == nullptr
                           ? "leave out the parentheses, or write * between"
                           : "it hides the function of that name: give it another name");
    return nullptr;
  }
  const Builtin* const builtin = find_builtin(call);
  if (builtin != nullptr) return builtin;
  report_unknown_function(call.callee, place);
  return nullptr;
}

Type ExpressionChecker::check_arguments(const Builtin& builtin, const Call& call, Place place) {
  const std::string needs = fmt::format("{} needs", builtin.name);
  const auto first = [&]() -> const Expr& { return *call.arguments.front(); };
  const auto only = [&](const Type& wanted, const Type& result) {
    return accept(first(), wanted, needs) ? result : Type{};
  };
  switch (builtin.rule) {
    case BuiltinRule::SameNumber:
      return common_dimension(call);
    case BuiltinRule::NumberToInt:
      return common_dimension(call).numeric() ? Type::integer() : Type{};
    case BuiltinRule::Root: {
      const Type type = common_dimension(call);
      if (!type.numeric()) return {};
      if (const auto root = root_of(type.dimension)) return Type::real(*root);
      diagnostics_.error(
          code::kDimensionMismatch, first().place,
          fmt::format("{} has no root: SQRT halves the exponents of the unit", in_words(type)));
      return {};
    }
    case BuiltinRule::SameReal: {
      const Type type = common_dimension(call);
      return type.numeric() ? Type::real(type.dimension) : Type{};
    }
    case BuiltinRule::SameToAngle:
      return common_dimension(call).numeric() ? Type::real(kAngle) : Type{};
    case BuiltinRule::AngleToReal:
      return only(Type::real(kAngle), Type::real());
    case BuiltinRule::RealToAngle:
      return only(Type::real(), Type::real(kAngle));
    case BuiltinRule::AngleToAngle:
      return only(Type::real(kAngle), Type::real(kAngle));
    case BuiltinRule::RealToReal:
      return only(Type::real(), Type::real());
    case BuiltinRule::RealToInt:
      return only(Type::real(), Type::integer());
    case BuiltinRule::AnyToText:
      return Type::string();
    case BuiltinRule::ArrayLength:
      return Type::integer();
    case BuiltinRule::Random:
      return call.arguments.empty() ? Type::real() : common_dimension(call);
    case BuiltinRule::ToFrame:
      return check_to_frame(call);
    case BuiltinRule::Forward:
      return accept(first(), joints(), needs) ? Type::pose() : Type{};
    case BuiltinRule::Wrench:
      return has_sensor(Reading::Wrench, place) ? Type{Type::Kind::Wrench} : Type{};
    case BuiltinRule::Joints:  // has been checked as a whole
      return {};
    case BuiltinRule::Places:
      return check_places(builtin, call);
    case BuiltinRule::Texts:
      return check_texts(builtin, call);
    case BuiltinRule::NumbersToVec: {
      const Type type = common_dimension(call);
      return type.known() ? Type::vec(type.dimension) : Type{};
    }
    default:
      return check_vectors(builtin, call);
  }
}

/// Functions of one VEC, or of two.
Type ExpressionChecker::check_vectors(const Builtin& builtin, const Call& call) {
  for (const ExprPtr& argument : call.arguments) {
    if (argument->type.is(Type::Kind::Vec)) continue;
    diagnostics_.error(
        code::kTypeMismatch, argument->place,
        fmt::format("{} needs a VEC; this is {}", builtin.name, described(*argument)),
        "for example (1mm, 2mm, 3mm)");
    return {};
  }
  const Expr& first = *call.arguments.front();
  const Expr& last = *call.arguments.back();
  const Dimension product = first.type.dimension * last.type.dimension;
  switch (builtin.rule) {
    case BuiltinRule::VecsToProduct:
      return bounded(product, last);
    case BuiltinRule::VecsToVec:
      return bounded(product, last).known() ? Type::vec(product) : Type{};
    case BuiltinRule::VecToDirection:
      return Type::vec(kNone);
    default:
      return accept(last, first.type, fmt::format("{} needs", builtin.name))
                 ? Type::real(first.type.dimension)
                 : Type{};
  }
}

Type ExpressionChecker::check_texts(const Builtin& builtin, const Call& call) {
  const std::string needs = fmt::format("{} needs", builtin.name);
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const Expr& argument = *call.arguments[i];
    const char letter = builtin.signature.parameters[i];
    if (letter != 'Q') {
      if (!accept(argument, letter == 'S' ? Type::string() : Type::integer(), needs)) return {};
    } else if (!argument.type.numeric()) {
      diagnostics_.error(code::kTypeMismatch, argument.place,
                         fmt::format("{} a number here; this is {}", needs, described(argument)));
      return {};
    } else if (!check_unit(argument, *call.arguments[i + 1])) {
      return {};
    }
  }
  switch (builtin.signature.result) {
    case 'S':
      return Type::string();
    case 'I':
      return Type::integer();
    default:
      return Type::real();
  }
}

/// The unit in which STR writes a value: known here, so that its dimension can be checked.
bool ExpressionChecker::check_unit(const Expr& value, const Expr& unit_text) {
  if (unit_text.type != Type::string()) return accept(unit_text, Type::string(), "STR needs");
  const auto* const text = std::get_if<std::string>(&unit_text.constant);
  if (text == nullptr) {
    diagnostics_.error(code::kUnitNotWritten, unit_text.place,
                       "STR needs its unit written out, so that it can be checked",
                       "for example STR(x, \"mm\", 1)");
    return false;
  }
  const auto unit = text->empty() ? Unit{} : find_unit(*text);
  if (!unit) {
    diagnostics_.error(code::kUnknownUnit, unit_text.place,
                       fmt::format("there is no unit {}", shortened(*text)),
                       did_you_mean(suggest(*text, {unit_names().begin(), unit_names().end()})));
    return false;
  }
  if (unit->dimension == value.type.dimension) return true;
  diagnostics_.error(code::kDimensionMismatch, unit_text.place,
                     fmt::format("{} is the unit of {}; the value is {}", *text,
                                 in_words(unit->dimension), described(value)),
                     fmt::format("write \"{}\"", lang::unit_text(value.type.dimension)));
  return false;
}

/// The type that all arguments share: INT, or REAL of one dimension.
Type ExpressionChecker::common_dimension(const Call& call) {
  Type common;
  for (const ExprPtr& argument : call.arguments) {
    if (!argument->type.numeric()) {
      diagnostics_.error(
          code::kTypeMismatch, argument->place,
          fmt::format("{} needs numbers; this is {}", to_upper(call.callee), described(*argument)));
      return {};
    }
    const Type next = common_type(common, argument->type);
    if (!next.numeric()) {
      diagnostics_.error(
          code::kDimensionMismatch, argument->place,
          fmt::format("this is {}; {} needs {} here, as before", described(*argument),
                      to_upper(call.callee), in_words(common)));
      return {};
    }
    common = next;
  }
  return common;
}

void ExpressionChecker::fold_call(const Builtin& builtin, const Call& call, Expr& expression) {
  if (builtin.rule == BuiltinRule::ArrayLength) return fold_length(call, expression);
  const bool computes = builtin.real != nullptr || builtin.rule == BuiltinRule::AnyToText;
  if (!computes) return;
  if (builtin.rule == BuiltinRule::AnyToText) {
    const Expr& value = *call.arguments.front();
    if (known(value.constant) && value.type != Type::string()) {
      expression.constant = text_of(value.constant, value.type);
    }
    return;
  }
  std::array<Constant, kMostArguments> arguments;
  const bool whole = computes_whole(builtin, call);
  const Type common = whole ? Type::integer() : Type::real();
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    arguments[i] = converted(known_value(*call.arguments[i]), common);
    if (!known(arguments[i])) return;
  }
  keep(fold(whole ? builtin.integer : builtin.real, {arguments.data(), call.arguments.size()},
            expression.type),
       expression);
}

}  // namespace rob::lang
