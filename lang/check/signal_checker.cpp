#include "lang/check/signal_checker.h"

#include <cstddef>
#include <string>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/check/meaning.h"
#include "lang/machine/machine.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/values/number_text.h"

namespace rob::lang {
namespace {

constexpr const char* kScaleExample = "SIGNAL wire: SPEED = AOUT[1] SCALE 0mm/s TO 300mm/s";

}  // namespace

/// Another name for a channel: what it does is the channel's.
void SignalChecker::check(SignalDeclaration& signal) {
  if (signal.type && !expressions_.complete(*signal.type, signal.type_place)) signal.type = Type{};
  const Symbol* const channel = expressions_.resolve_channel(signal.channel, signal.channel_place);
  expressions_.check(signal.low);
  expressions_.check(signal.high);
  expressions_.check(signal.safe);
  if (channel == nullptr) {
    declarations_.declare(Symbol::Kind::Variable, signal.name, signal.name_place, {}, {});
    return;
  }
  declarations_.warn_of_name(Symbol::Kind::Signal, signal.name, signal.name_place);
  Symbol symbol = *channel;
  symbol.name = signal.name;
  symbol.place = signal.name_place;
  const std::size_t found = diagnostics_.all().size();
  if (signal.last != nullptr) {
    check_group(signal, *channel, symbol);
  } else if (channel->analog) {
    check_analog(signal, symbol);
  } else {
    check_digital(signal, *channel);
  }
  const bool sound = diagnostics_.all().size() == found;
  if (signal.safe != nullptr && sound) check_safe(signal, symbol);
  signal.symbol = scopes_.declare(std::move(symbol));
}

/// SIGNAL code: INT = DIN[1..8]: the first channel is the lowest bit.
void SignalChecker::check_group(const SignalDeclaration& signal, const Symbol& first,
                                Symbol& symbol) {
  constexpr std::int64_t kMostBits = 63;  // of an INT that is not negative
  const Type type = expressions_.check(signal.last);
  symbol.type = Type::integer();
  if (!type.known()) return;
  const auto* const last = std::get_if<std::int64_t>(&signal.last->constant);
  const auto refuse = [&](Place place, std::string message, std::string help = "") {
    diagnostics_.error(code::kGroup, place, std::move(message), std::move(help));
  };
  if (last == nullptr)
    return refuse(signal.last->place, "the numbers of a group are constant whole numbers");
  const std::int64_t count = *last - first.channel + 1;
  if (count < 2 || count > kMostBits) {
    return refuse(signal.last->place, fmt::format("a group has 2 to {} channels", kMostBits),
                  "the lower number comes first: DIN[1..8]");
  }
  if (first.analog) {
    return refuse(signal.channel_place, "the channels of a group are digital: DIN or DOUT");
  }
  if (signal.low != nullptr || signal.safe != nullptr) {
    return refuse((signal.low != nullptr ? signal.low : signal.safe)->place,
                  "a group has neither SCALE nor SAFE", "SAFE stands at a single channel");
  }
  if (signal.type && *signal.type != Type::integer()) {
    return refuse(signal.type_place, "a group of channels is an INT",
                  "SIGNAL code: INT = DIN[1..8]");
  }
  for (std::int64_t number = first.channel; number <= *last; ++number) {
    const Symbol* const channel = scopes_.channel(signal.channel.text, number);
    if (channel == nullptr) {
      return refuse(signal.last->place,
                    fmt::format("the robot has no {}[{}]", signal.channel.text, number),
                    fmt::format("it has {0}[1] to {0}[{1}]", signal.channel.text,
                                scopes_.channels(signal.channel.text)));
    }
  }
  symbol.group = static_cast<int>(count);
}

void SignalChecker::check_digital(const SignalDeclaration& signal, const Symbol& channel) {
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
void SignalChecker::check_analog(const SignalDeclaration& signal, Symbol& symbol) {
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

void SignalChecker::check_scale(const SignalDeclaration& signal, Symbol& symbol) {
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
  const bool sound = values_.accept(*signal.low, wanted, "SCALE needs") &&
                     values_.accept(*signal.high, wanted, "SCALE needs");
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

std::optional<double> SignalChecker::constant_end(const Expr& end) {
  const Constant value = converted(end.constant, Type::real());
  if (const double* const number = std::get_if<double>(&value)) return *number;
  diagnostics_.error(code::kScaleNoRange, end.place,
                     "the ends of a SCALE must be known before the program runs",
                     "write a number with its unit, or a CONST");
  return std::nullopt;
}

void SignalChecker::check_safe(SignalDeclaration& signal, const Symbol& symbol) {
  const Expr& safe = *signal.safe;
  if (!symbol.output) {
    return diagnostics_.error(
        code::kSafeInput, safe.place,
        fmt::format("{} is an input; only an output can be given a SAFE value",
                    shortened(symbol.name)),
        "leave SAFE out, or name a DOUT[n] or AOUT[n]");
  }
  if (symbol.type.kind == Type::Kind::Unknown) return;
  if (!values_.accept(safe, symbol.type, "SAFE needs")) return;
  if (safe.type.kind == Type::Kind::Unknown) return;
  const auto [known, is_new] = safe_lines_.try_emplace(symbol.signal, signal.name_place);
  if (!is_new) {
    return diagnostics_.error(
        code::kSafeTwice, safe.place,
        fmt::format("the channel of {} has a SAFE value already, in {}", shortened(symbol.name),
                    diagnostics_.line_of(known->second, safe.place)),
        "an output has one SAFE value, whatever it is called");
  }
  if (const std::optional<double> value = safe_value(safe, symbol)) signal.safe_value = *value;
}

/// 1 for ON, V; nothing, with an error, where the channel cannot have it.
std::optional<double> SignalChecker::safe_value(const Expr& safe, const Symbol& symbol) {
  if (!known(safe.constant)) {
    diagnostics_.error(
        code::kSafeUnknown, safe.place, "a SAFE value must be known before the program runs",
        symbol.analog ? "write a number with its unit, or a CONST" : "write ON or OFF, or a CONST");
    return std::nullopt;
  }
  if (!symbol.analog) return std::get<bool>(safe.constant) ? 1 : 0;
  constexpr double kSame = 1e-9;  // V: what rounding can add at the end of a SCALE
  const double number = std::get<double>(converted(safe.constant, Type::real()));
  const double volts = (number - symbol.low) / (symbol.high - symbol.low) * kMostVolts;
  if (volts >= -kSame && volts <= kMostVolts + kSame) return volts;
  const Dimension dimension = symbol.type.dimension;
  diagnostics_.error(
      code::kSafeBeyond, safe.place,
      fmt::format("{} carries {} to {}; its SAFE value is {}", shortened(symbol.name),
                  number_text(symbol.low, dimension), number_text(symbol.high, dimension),
                  number_text(number, dimension)),
      "choose a value within its SCALE");
  return std::nullopt;
}

const Symbol* SignalChecker::resolve(Name& name, Place place) {
  name.symbol = name.index != nullptr ? expressions_.resolve_channel(name, place)
                                      : names_.resolve(name.text, place);
  return name.symbol;
}

void SignalChecker::check(Pulse& pulse) {
  expressions_.check(pulse.time);
  const Symbol* const symbol = resolve(pulse.target, pulse.target_place);
  if (pulse.time != nullptr) {
    values_.accept(*pulse.time, Type::real(kTime), "PULSE needs");
    const std::optional<double> time = constant_number(*pulse.time);
    if (time && pulse.time->type == Type::real(kTime) && !(*time > 0 && *time <= kLongestPulse)) {
      diagnostics_.error(code::kPulseTime, pulse.time->place,
                         fmt::format("PULSE needs a time above 0s and up to {}; this is {}",
                                     number_text(kLongestPulse, kTime), described(*pulse.time)));
    }
  }
  if (symbol == nullptr || symbol->type.kind == Type::Kind::Unknown) return;
  if (symbol->kind == Symbol::Kind::Signal && symbol->output && !symbol->analog &&
      symbol->group == 0)
    return;
  diagnostics_.error(code::kNotPulsable, pulse.target_place,
                     fmt::format("{} is no digital output; PULSE switches one ON for a time",
                                 shortened(symbol->name)),
                     "for example PULSE gripper 50ms");
}

void SignalChecker::know(const KeptName& kept, const Symbol& symbol) {
  if (kept.safe) safe_lines_.try_emplace(symbol.signal, symbol.place);
}

void SignalChecker::check(Simulate& simulation) {
  expressions_.check(simulation.value);
  expressions_.check(simulation.after);
  const bool input = simulation.what == Simulate::What::Input;
  if (!input) check_operator(simulation);
  if (input && simulation.target.index == nullptr && is_device(simulation.target.text)) {
    return check_device(simulation);
  }
  const Symbol* const symbol =
      input ? resolve(simulation.target, simulation.target_place) : nullptr;
  simulation.target.symbol = symbol;
  if (simulation.after != nullptr) {
    values_.accept(*simulation.after, Type::real(kTime), "AFTER needs");
    values_.require_time(*simulation.after, "AFTER");
  }
  if (symbol == nullptr || !symbol->type.known()) return;
  if (symbol->kind == Symbol::Kind::Reading && needs_sensor(symbol->reading)) {
    check_force(simulation, *symbol);
  } else {
    check_input(simulation, *symbol);
  }
}

void SignalChecker::check_input(Simulate& simulation, const Symbol& symbol) {
  if (!simulation.part.empty()) {
    diagnostics_.error(
        code::kForcePart, simulation.part_place,
        fmt::format("{} is one value; only force and torque have parts", shortened(symbol.name)));
    return;
  }
  if (symbol.kind != Symbol::Kind::Signal || symbol.output) {
    diagnostics_.error(
        code::kNotSimulated, simulation.target_place,
        fmt::format("{} is no input; SIMULATE gives an input its value", shortened(symbol.name)),
        "SIMULATE part_here = ON AFTER 2s");
    return;
  }
  if (simulation.value != nullptr) {
    values_.accept(*simulation.value, symbol.type, fmt::format("{} needs", shortened(symbol.name)));
  }
}

/// SIMULATE force.z = 5N
void SignalChecker::check_force(Simulate& simulation, const Symbol& symbol) {
  if (!expressions_.has_sensor(symbol.reading, simulation.target_place)) return;
  const auto part = field_of(symbol.type, simulation.part);
  if (!part) {
    diagnostics_.error(code::kForcePart,
                       simulation.part.empty() ? simulation.target_place : simulation.part_place,
                       fmt::format("SIMULATE sets one part of {} at a time", symbol.name),
                       fmt::format("write {0}.x, {0}.y or {0}.z", symbol.name));
    return;
  }
  simulation.component = part->offset.numbers + (symbol.reading == Reading::Torque ? 3 : 0);
  if (simulation.value != nullptr) {
    values_.accept(*simulation.value, part->type,
                   fmt::format("{}.{} needs", symbol.name, simulation.part));
  }
}

bool SignalChecker::is_device(std::string_view name) const {
  const Symbol* const symbol = scopes_.find(name);
  return symbol != nullptr && symbol->kind == Symbol::Kind::Device;
}

/// SIMULATE scale = "12.5 g": a line that it sends.
void SignalChecker::check_device(Simulate& simulation) {
  simulation.what = Simulate::What::Device;
  simulation.target.symbol = names_.resolve_device(simulation.target.text, simulation.target_place);
  if (simulation.value != nullptr)
    values_.accept(*simulation.value, Type::string(), "SIMULATE of a device needs");
  if (simulation.after == nullptr) return;
  values_.accept(*simulation.after, Type::real(kTime), "AFTER needs");
  values_.require_time(*simulation.after, "AFTER");
}

void SignalChecker::check_operator(const Simulate& simulation) {
  if (simulation.value == nullptr) return;
  const bool go = simulation.what == Simulate::What::Go;
  values_.accept(*simulation.value, go ? Type::boolean() : Type::string(),
                 go ? "GO needs" : "ANSWER needs");
}

}  // namespace rob::lang
