#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/check/statement_checker.h"
#include "lang/check/target.h"
#include "lang/machine/machine.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/values/number_text.h"

/// Member functions of StatementChecker for SIGNAL: names for channels, and the meaning of their
/// volts.
namespace rob::lang {
namespace {

constexpr const char* kScaleExample = "SIGNAL wire: SPEED = AOUT[1] SCALE 0mm/s TO 300mm/s";

}  // namespace

/// Another name for a channel: what it does is the channel's.
void StatementChecker::check(SignalDeclaration& signal) {
  if (signal.type && !expressions_.complete(*signal.type, signal.type_place)) signal.type = Type{};
  const Symbol* const channel = expressions_.resolve_channel(signal.channel, signal.channel_place);
  expressions_.check(signal.low);
  expressions_.check(signal.high);
  expressions_.check(signal.safe);
  if (channel == nullptr) {
    declare(Symbol::Kind::Variable, signal.name, signal.name_place, {}, {});
    return;
  }
  warn_of_name(Symbol::Kind::Signal, signal.name, signal.name_place);
  Symbol symbol = *channel;
  symbol.name = signal.name;
  symbol.place = signal.name_place;
  const std::size_t found = diagnostics_.all().size();
  if (channel->analog) {
    check_analog(signal, symbol);
  } else {
    check_digital(signal, *channel);
  }
  const bool sound = diagnostics_.all().size() == found;
  if (signal.safe != nullptr && sound) check_safe(signal, symbol);
  signal.symbol = scopes_.declare(std::move(symbol));
}

void StatementChecker::check_digital(const SignalDeclaration& signal, const Symbol& channel) {
  if (signal.type && *signal.type != Type::boolean() && signal.type->kind != Type::Kind::Unknown) {
    diagnostics_.error(
        code::kSignalType, signal.type_place,
        fmt::format("{} is ON or OFF; it cannot be {}", channel.name, in_words(*signal.type)),
        fmt::format("a quantity needs an analog channel: {}", kScaleExample));
  } else if (signal.low != nullptr) {
    diagnostics_.error(code::kSignalType, signal.low->place,
                       fmt::format("{} is ON or OFF; it has no SCALE", channel.name),
                       fmt::format("SCALE belongs to an analog channel: {}", kScaleExample));
  }
}

/// Settles the type of an analog signal and what its volts stand for.
void StatementChecker::check_analog(const SignalDeclaration& signal, Symbol& symbol) {
  symbol.type = Type::real(kVoltage);
  if (signal.type) symbol.type = *signal.type;
  if (symbol.type.kind == Type::Kind::Unknown) return;
  if (symbol.type.kind != Type::Kind::Real) {
    diagnostics_.error(
        code::kSignalType, signal.type_place,
        fmt::format("an analog signal is a REAL or a quantity, not {}", in_words(symbol.type)),
        kScaleExample);
    symbol.type = {};
    return;
  }
  if (signal.low != nullptr && signal.high != nullptr) {
    check_scale(signal, symbol);
  } else if (symbol.type != Type::real(kVoltage)) {
    diagnostics_.error(
        code::kSignalType, signal.type_place,
        fmt::format("the channel carries a voltage; what it stands for as {} is missing",
                    in_words(symbol.type)),
        kScaleExample);
  }
}

void StatementChecker::check_scale(const SignalDeclaration& signal, Symbol& symbol) {
  if (!signal.type) {
    const Type type = common_type(signal.low->type, signal.high->type);
    symbol.type = type.numeric() ? Type::real(type.dimension) : Type{};
    if (!type.numeric() && signal.low->type.numeric() && signal.high->type.numeric()) {
      diagnostics_.error(code::kDimensionMismatch, signal.high->place,
                         fmt::format("this is {}; the SCALE began with {}", described(*signal.high),
                                     in_words(signal.low->type)),
                         "both ends need the same unit");
      return;
    }
  }
  const Type wanted = symbol.type.kind == Type::Kind::Real ? symbol.type : Type::real();
  const bool sound = expressions_.accept(*signal.low, wanted, "SCALE needs") &&
                     expressions_.accept(*signal.high, wanted, "SCALE needs");
  if (!sound || signal.low->type.kind == Type::Kind::Unknown ||
      signal.high->type.kind == Type::Kind::Unknown) {
    return;
  }
  const std::optional<double> low = constant_end(*signal.low);
  const std::optional<double> high = constant_end(*signal.high);
  if (!low || !high) return;
  if (*low == *high) {
    diagnostics_.error(
        code::kScaleNoRange, signal.high->place,
        "both ends of this SCALE are the same: no voltage could be found for a value",
        kScaleExample);
    return;
  }
  symbol.low = *low;
  symbol.high = *high;
}

const Symbol* StatementChecker::resolve_signal(Name& name, Place place) {
  name.symbol = name.index != nullptr ? expressions_.resolve_channel(name, place)
                                      : expressions_.resolve(name.text, place);
  return name.symbol;
}

void StatementChecker::check(Pulse& pulse) {
  expressions_.check(pulse.time);
  const Symbol* const symbol = resolve_signal(pulse.target, pulse.target_place);
  if (pulse.time != nullptr) {
    expressions_.accept(*pulse.time, Type::real(kTime), "PULSE needs");
    const std::optional<double> time = constant_number(*pulse.time);
    if (time && pulse.time->type == Type::real(kTime) && !(*time > 0 && *time <= kLongestPulse)) {
      diagnostics_.error(code::kPulseTime, pulse.time->place,
                         fmt::format("PULSE needs a time above 0s and up to {}; this is {}",
                                     number_text(kLongestPulse, kTime), described(*pulse.time)));
    }
  }
  if (symbol == nullptr || symbol->type.kind == Type::Kind::Unknown) return;
  if (symbol->kind == Symbol::Kind::Signal && symbol->output && !symbol->analog) return;
  diagnostics_.error(code::kNotPulsable, pulse.target_place,
                     fmt::format("{} is no digital output; PULSE switches one ON for a time",
                                 shortened(symbol->name)),
                     "for example PULSE gripper 50ms");
}

std::optional<double> StatementChecker::constant_end(const Expr& end) {
  const Constant value = converted(end.constant, Type::real());
  if (const double* const number = std::get_if<double>(&value)) return *number;
  diagnostics_.error(code::kScaleNoRange, end.place,
                     "the ends of a SCALE have to be known before the program runs",
                     "write a number with its unit, or a CONST");
  return std::nullopt;
}

}  // namespace rob::lang
