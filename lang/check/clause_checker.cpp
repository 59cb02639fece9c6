#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "lang/check/clause_checker.h"
#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/text/codes.h"
#include "lang/values/number_text.h"
#include "lang/values/percent_text.h"
#include "lang/values/setting.h"

namespace rob::lang {
namespace {

/// Whether an expression is made of nothing but numbers without a unit.
bool only_bare_literals(const Expr& expression) {
  struct Visitor {
    bool operator()(const NumberLiteral& literal) const { return !literal.has_unit; }
    bool operator()(const Unary& unary) const { return only_bare_literals(*unary.operand); }
    bool operator()(const Binary& binary) const {
      return only_bare_literals(*binary.left) && only_bare_literals(*binary.right);
    }
    bool operator()(const Chain& chain) const {
      return only_bare_literals(*chain.first) &&
             std::ranges::all_of(chain.steps, [](const Chain::Step& step) {
               return only_bare_literals(*step.term);
             });
    }
    bool operator()(const Call& call) const {
      return call.routine == nullptr &&
             std::ranges::all_of(call.arguments, [](const ExprPtr& argument) {
               return only_bare_literals(*argument);
             });
    }
    bool operator()(const BoolLiteral&) const { return false; }
    bool operator()(const StringLiteral&) const { return false; }
    bool operator()(const Name&) const { return false; }
    bool operator()(const Tuple&) const { return false; }
    bool operator()(const List&) const { return false; }
    bool operator()(const Member&) const { return false; }
    bool operator()(const Index&) const { return false; }
  };
  return std::visit(Visitor{}, expression.node);
}

bool needs_unit(const Expr& value) {
  return value.type == Type::integer() || (is_bare(value.type) && only_bare_literals(value));
}

}  // namespace

bool ClauseChecker::check(const Clauses& clauses, Place place) {
  bool sound = check(clauses.surroundings);
  if (clauses.near != nullptr) {
    sound = expressions_.check_as(clauses.near, expressions_.joints(), "NEAR needs") &&
            clauses.near->type.known() && sound;
  }
  for (std::size_t i = 0; i < kClauses; ++i) {
    if (clauses.values[i] == nullptr) continue;
    expressions_.check(clauses.values[i]);
    sound = check(static_cast<Clause>(i), *clauses.values[i]) && sound;
  }
  if (!clauses.fine || clauses[Clause::Zone] == nullptr) return sound;
  diagnostics_.error(code::kFineWithZone, place,
                     "FINE reaches the target exactly, ZONE rounds its corner: they exclude each"
                     " other",
                     "keep one of the two");
  return false;
}

void ClauseChecker::check_defaults(const Clauses& clauses, std::string_view word, Place place) {
  check(clauses, place);
  const bool fixed = word == "DEFAULT";
  const Surroundings& around = clauses.surroundings;
  const char* const misplaced = clauses.profile != Profile::Unspecified ? "PROFILE"
                                : clauses[Clause::Over] != nullptr      ? "OVER"
                                : clauses[Clause::Jerk] != nullptr      ? "JERK"
                                : clauses[Clause::For] != nullptr       ? "FOR"
                                : clauses.euler                         ? "EULER"
                                : clauses.near != nullptr               ? "NEAR"
                                : clauses.free != FreeTurn::None        ? "FREE"
                                : fixed && around.tool != nullptr       ? "WITH"
                                : fixed && around.has_frame()           ? "IN"
                                                                        : nullptr;
  if (clauses.live) {
    diagnostics_.error(code::kClauseMisplaced, clauses.live_place,
                       fmt::format("AT LIVE does not stand after {}", word),
                       "it stands after a motion or a PATH");
  } else if (misplaced != nullptr) {
    diagnostics_.error(code::kClauseMisplaced, place,
                       fmt::format("{} does not stand after {}", misplaced, word),
                       "AT, ZONE, FINE and ACCEL do: for each motion that does not say otherwise");
  }
  for (const ExprPtr& value : clauses.values) {
    if (!fixed || value == nullptr || !value->type.known() || known(value->constant)) continue;
    diagnostics_.error(code::kDefaultComputed, value->place, "the values of DEFAULT are constant",
                       "write a number with its unit, or a CONST; WITH … DO takes computed ones");
  }
}

bool ClauseChecker::check(Clause clause, const Expr& value) {
  if (value.type.kind == Type::Kind::Unknown) return false;
  switch (clause) {
    case Clause::At:
      return check_at(value);
    case Clause::Over:
      return values_.accept(value, Type::real(kTime), "OVER needs") &&
             check_positive(value, "OVER");
    case Clause::Accel:
      return check_bound(value, "ACCEL", "an acceleration", "100mm/s^2",
                         accel_of(value.type).has_value());
    case Clause::Jerk:
      return check_bound(value, "JERK", "a jerk", "1000mm/s^3", jerk_of(value.type).has_value());
    case Clause::Zone:
      return check_zone(value);
    case Clause::ZoneAngle:
      return values_.accept(value, Type::real(kAngle), "after its first value ZONE needs") &&
             check_positive(value, "the angle of ZONE");
    case Clause::Fine:
      return check_fine(value);
    case Clause::For:
      return values_.accept(value, Type::real(kTime), "FOR needs") && check_positive(value, "FOR");
  }
  return false;
}

bool ClauseChecker::check(const Surroundings& surroundings) {
  bool sound = true;
  const auto require = [&](const ExprPtr& name, Type::Kind kind, std::string_view code,
                           std::string_view message, const char* help) {
    if (name == nullptr) return;
    const Type type = expressions_.check(name);
    sound = sound && type.is(kind);
    if (!type.known() || type.is(kind)) return;
    diagnostics_.error(code, name->place, fmt::format("{}; this is {}", message, described(*name)),
                       help);
  };
  require(surroundings.tool, Type::Kind::Tool, code::kNoTool, "WITH needs the name of a TOOL",
          "TOOL cup = POSE(…) declares one");
  require(surroundings.frame, Type::Kind::Frame, code::kNoFrame, "IN needs the name of a FRAME",
          "FRAME pallet = POSE(…) declares one");
  return sound;
}

void ClauseChecker::check_override(const ExprPtr& share) {
  if (!expressions_.check(share).known()) return;
  const auto number = constant_number(*share);
  if (needs_unit(*share)) {
    diagnostics_.error(code::kShareWithoutPercent, share->place,
                       fmt::format("OVERRIDE needs a share; this is {}", described(*share)),
                       number ? fmt::format("write OVERRIDE {}%", number_text(*number, kNone))
                              : "as in OVERRIDE 30%");
  } else if (values_.accept(*share, Type::real(), "OVERRIDE needs") && number &&
             !(*number > 0 && *number <= kMostOverride)) {
    diagnostics_.error(
        code::kOverrideBeyond, share->place,
        fmt::format("OVERRIDE is above 0% and at most 200%; this is {}", percent_text(*number)),
        std::string(override_help(*number)));
  }
}

bool ClauseChecker::check_bound(const Expr& value, std::string_view word, std::string_view needed,
                                std::string_view example, bool fits) {
  const auto number = constant_number(value);
  const bool bare = needs_unit(value);
  if (fits && !bare) {
    if (!check_positive(value, word)) return false;
    if (is_bare(value.type) && number.value_or(0) > 1) {
      diagnostics_.warning(code::kBoundAboveMaximum, value.place,
                           fmt::format("{} {} is more than the robot can; it keeps 100%", word,
                                       percent_text(*number)));
    }
    return true;
  }
  const bool share = bare && number.value_or(0) > 0;
  diagnostics_.error(
      value.type.numeric() ? code::kDimensionMismatch : code::kTypeMismatch, value.place,
      fmt::format("this is {}; {} needs {} of the tool or of the rotary axes", described(value),
                  word, needed),
      share ? fmt::format("write {} {}% for a share of the robot's own, or {} {}", word,
                          number_text(*number < 1 ? *number * 100 : *number, kNone), word, example)
            : fmt::format("as in {} {}", word, example));
  return false;
}

bool ClauseChecker::check_zone(const Expr& value) {
  const auto number = constant_number(value);
  if (!number || *number != 0 || !is_bare(value.type)) {  // ZONE 0 needs no unit
    if (needs_unit(value)) {
      diagnostics_.error(
          code::kZoneWithoutUnit, value.place,
          fmt::format("ZONE needs a length, a time or a share; this is {}", described(value)),
          number ? fmt::format("write ZONE {}mm", number_text(*number, kNone))
                 : "as in ZONE 5mm, ZONE 0.5s or ZONE 50%");
      return false;
    }
    if (!zone_of(value.type)) {
      diagnostics_.error(
          value.type.numeric() ? code::kDimensionMismatch : code::kTypeMismatch, value.place,
          fmt::format("this is {}; ZONE needs a length, a time or a share", described(value)),
          "as in ZONE 5mm, ZONE 0.5s or ZONE 50%");
      return false;
    }
  }
  if (!number || *number >= 0) return true;
  diagnostics_.error(
      code::kNegativeZone, value.place,
      fmt::format("ZONE needs zero or more; this is {}", text_of(value.constant, value.type)),
      "ZONE 0, or FINE, reaches the target exactly");
  return false;
}

bool ClauseChecker::check_fine(const Expr& value) {
  const auto number = constant_number(value);
  if (!needs_unit(value)) {
    return values_.accept(value, Type::real(kLength), "FINE needs") &&
           check_positive(value, "FINE");
  }
  diagnostics_.error(
      code::kFineWithoutUnit, value.place,
      fmt::format("FINE needs a length; this is {}", described(value)),
      number ? fmt::format("write FINE {}mm", number_text(*number, kNone)) : "as in FINE 0.1mm");
  return false;
}

bool ClauseChecker::check_at(const Expr& at_expression) {
  const Type& type = at_expression.type;
  if (needs_unit(at_expression)) {
    const auto value = constant_number(at_expression);
    // A number from 1 on is a percentage or a speed without its unit; below, a share of 1.
    const double percent = value.value_or(50) < 1 ? value.value_or(0.5) * 100 : value.value_or(50);
    diagnostics_.error(
        code::kShareWithoutPercent, at_expression.place,
        fmt::format("AT needs a speed or a share; this is {}", described(at_expression)),
        fmt::format("write AT {}% or AT {}mm/s", number_text(percent, kNone),
                    number_text(value.value_or(50), kNone)));
    return false;
  }
  if (!pace_of(type)) {
    diagnostics_.error(
        type.numeric() ? code::kDimensionMismatch : code::kTypeMismatch, at_expression.place,
        fmt::format("this is {}; AT needs a speed, an angular speed or a share here",
                    described(at_expression)),
        type == Type::real(kTime) ? "a duration is given by OVER" : "as in AT 20mm/s or AT 50%");
    return false;
  }
  if (!check_positive(at_expression, "AT")) return false;
  if (is_bare(type) && constant_number(at_expression).value_or(0) > 1) {
    diagnostics_.warning(code::kAboveMaximum, at_expression.place,
                         fmt::format("{} is more than the robot can; it moves at 100%",
                                     percent_text(*constant_number(at_expression))));
  }
  return true;
}

bool ClauseChecker::check_positive(const Expr& value, std::string_view word) {
  const auto number = constant_number(value);
  if (!number || *number > 0) return true;
  diagnostics_.error(code::kNotPositive, value.place,
                     fmt::format("{} needs a value above zero; this is {}", word,
                                 text_of(value.constant, value.type)));
  return false;
}

}  // namespace rob::lang
