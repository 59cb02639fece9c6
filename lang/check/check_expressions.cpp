#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "lang/check/declared_elsewhere.h"
#include "lang/check/expression_checker.h"
#include "lang/check/target.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/text/suggest.h"
#include "lang/values/number_text.h"
#include "lang/values/units.h"

/// Member functions of ExpressionChecker for literals and names. They also check whether a place
/// accepts a value.
namespace rob::lang {

std::string described(const Expr& expression) {
  const std::string words = in_words(expression.type);
  // A long text would bury the message.
  if (!known(expression.constant) || expression.type.kind == Type::Kind::String) return words;
  return words + ", " + text_of(expression.constant, expression.type);
}

Type ExpressionChecker::check(const ExprPtr& expression) {
  if (expression == nullptr) return {};
  expression->type = check_node(*expression);
  memory_use_ = memory_use_ || !expression->type.in_registers();
  return expression->type;
}

Type ExpressionChecker::check_node(Expr& expression) {
  return std::visit([&](auto& node) { return check(node, expression); }, expression.node);
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
                                      : resolve(name.text, expression.place);
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
  const Type type = check(unary.operand);
  const bool negation = unary.op == UnaryOp::Not;
  if (type.kind == Type::Kind::Unknown) return negation ? Type::boolean() : type;
  if (negation ? type == Type::boolean() : type.numeric() || type.is(Type::Kind::Vec)) {
    expression.type = type;
    if (known(unary.operand->constant)) keep(fold(unary.op, unary.operand->constant), expression);
    return type;
  }
  if (negation) {
    diagnostics_.error(code::kTypeMismatch, unary.operand->place,
                       "NOT needs TRUE or FALSE; this is " + described(*unary.operand));
    return Type::boolean();
  }
  diagnostics_.error(code::kTypeMismatch, unary.operand->place,
                     fmt::format("'{}' needs a number; this is {}",
                                 unary.op == UnaryOp::Plus ? '+' : '-', described(*unary.operand)));
  return {};
}

bool ExpressionChecker::accept(const Expr& expression, const Type& wanted,
                               std::string_view needed) {
  const Type& type = expression.type;
  if (type.kind == Type::Kind::Unknown || wanted.kind == Type::Kind::Unknown) return true;
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
  if (const auto* const list = std::get_if<List>(&expression.node);
      list != nullptr && wanted.is(Type::Kind::Array)) {
    return accept_list(expression, *list, wanted, needed);
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
  diagnostics_.error(
      quantities ? code::kDimensionMismatch : code::kTypeMismatch, expression.place,
      fmt::format("this is {}; {} {} here", described(expression), needed, in_words(wanted)), help);
  return false;
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

const Symbol* ExpressionChecker::resolve(std::string_view name, Place place) {
  const Symbol* const symbol = scopes_.find(name);
  if (symbol != nullptr && report_ambiguous(name, place)) return nullptr;
  if (symbol == nullptr) {
    report_unknown(name, place);
  } else if (symbol->kind == Symbol::Kind::Routine) {
    diagnostics_.error(code::kNotAFunction, place,
                       fmt::format("{} is a routine, not a value", shortened(name)),
                       fmt::format("call it: {}(…)", shortened(name)));
    return nullptr;
  } else if (symbol->kind == Symbol::Kind::Record) {
    diagnostics_.error(code::kNotAFunction, place,
                       fmt::format("{} is a record, not a value", shortened(name)),
                       fmt::format("build one: {}(…)", shortened(name)));
    return nullptr;
  } else {
    uses_.used(*symbol);
  }
  return symbol;
}

const Symbol* ExpressionChecker::resolve_channel(Name& name, Place place) {
  const Type type = check(name.index);
  if (type.kind == Type::Kind::Unknown) return nullptr;
  const auto* const number = std::get_if<std::int64_t>(&name.index->constant);
  if (number == nullptr) {
    diagnostics_.error(code::kChannelNotConstant, name.index->place,
                       fmt::format("the number of {} has to be a constant whole number; this is {}",
                                   name.text, described(*name.index)));
    return nullptr;
  }
  if (const Symbol* const found = scopes_.channel(name.text, *number)) return found;
  const std::int64_t count = scopes_.channels(name.text);
  diagnostics_.error(code::kNoSuchChannel, place,
                     fmt::format("the robot has no {}[{}]", name.text, *number),
                     count == 0 ? fmt::format("it has no {} at all", name.text)
                                : fmt::format("it has {0}[1] to {0}[{1}]", name.text, count));
  return nullptr;
}

void ExpressionChecker::report_unknown(std::string_view name, Place place) {
  // What is only counted need not be searched for.
  if (diagnostics_.error_count() >= Diagnostics::kMost) {
    diagnostics_.error(code::kUnknownName, place, "unknown name");
    return;
  }
  if (find_builtin(name, 0) != nullptr) {
    diagnostics_.error(code::kNotAFunction, place, fmt::format("{} is a function", name),
                       fmt::format("give it its arguments: {}(…)", to_upper(name)));
    return;
  }
  if (scopes_.is_file(name.substr(0, name.find('.')))) {
    return report_no_such_name(name, place);
  }
  if (const auto declared = find_declaration(program_, name, place.file)) {
    const bool later = declared->line > place.line ||
                       (declared->line == place.line && declared->column >= place.column);
    diagnostics_.error(
        code::kUnknownName, place, fmt::format("{} is not known here", shortened(name)),
        later || declared->line == place.line
            ? fmt::format("it is declared in line {}: declare it before using it", declared->line)
            : fmt::format("it is declared in the block of line {} and lives only there",
                          declared->line));
    return;
  }
  std::string help = did_you_mean(suggest(name, scopes_.visible()));
  if (help.empty() && find_unit(name)) {
    help = fmt::format("a unit stands behind its number, without a blank: 1{}", name);
  }
  diagnostics_.error(code::kUnknownName, place, fmt::format("unknown name {}", shortened(name)),
                     std::move(help));
}

void ExpressionChecker::keep(const Folded& folded, Expr& expression) {
  if (folded.error == ArithmeticError::None) {
    expression.constant = folded.value;
  } else if (reached()) {
    const ArithmeticErrorText text = describe(folded.error);
    diagnostics_.error(text.code, expression.place, std::string(text.message),
                       std::string(text.help));
  }
}

}  // namespace rob::lang
