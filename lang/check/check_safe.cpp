#include <optional>
#include <variant>

#include <fmt/core.h>

#include "lang/check/fold.h"
#include "lang/check/statement_checker.h"
#include "lang/text/ascii.h"
#include "lang/text/codes.h"
#include "lang/values/number_text.h"

/// Member functions of StatementChecker for SAFE: the value of an output after a run has failed.
namespace rob::lang {

void StatementChecker::check_safe(SignalDeclaration& signal, const Symbol& symbol) {
  const Expr& safe = *signal.safe;
  if (!symbol.output) {
    return diagnostics_.error(
        code::kSafeInput, safe.place,
        fmt::format("{} is an input; only an output can be given a SAFE value",
                    shortened(symbol.name)),
        "leave SAFE out, or name a DOUT[n] or AOUT[n]");
  }
  if (symbol.type.kind == Type::Kind::Unknown) return;
  if (!expressions_.accept(safe, symbol.type, "SAFE needs")) return;
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
std::optional<double> StatementChecker::safe_value(const Expr& safe, const Symbol& symbol) {
  if (!known(safe.constant)) {
    diagnostics_.error(
        code::kSafeUnknown, safe.place, "a SAFE value has to be known before the program runs",
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

}  // namespace rob::lang
