#include "lang/values/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "lang/text/ascii.h"

namespace rob::lang {

namespace {

struct NamedUnit {
  std::string_view name;
  Unit unit;
};

/// in: 25.4 mm exactly (international yard and pound agreement, 1959). A newton is 1000 kg*mm/s^2.
constexpr auto kUnits = std::to_array<NamedUnit>({
    {"um", {kLength, -3}},
    {"mm", {kLength}},
    {"cm", {kLength, 1}},
    {"m", {kLength, 3}},
    {"in", {kLength, -1, 254}},
    {"deg", {kAngle}},
    {"rad", {kAngle, 0, 180, std::numbers::pi}},
    {"rev", {kAngle, 0, 360}},
    {"rpm", {kAngularSpeed, 0, 6}},
    {"us", {kTime, -6}},
    {"ms", {kTime, -3}},
    {"s", {kTime}},
    {"min", {kTime, 0, 60}},
    {"h", {kTime, 0, 3600}},
    {"N", {kForce, 3}},
    {"kN", {kForce, 6}},
    {"Nm", {kTorque, 6}},
    {"g", {kMass, -3}},
    {"kg", {kMass}},
    {"Hz", {kFrequency}},
    {"V", {kVoltage}},
    {"%", {kNone, -2}},
});

constexpr auto kUnitNames = [] {
  std::array<std::string_view, kUnits.size()> names;
  std::ranges::transform(kUnits, names.begin(), &NamedUnit::name);
  return names;
}();

/// The letters of a word, or "%", at the beginning of `text`.
std::string_view leading_word(std::string_view text) {
  if (text.starts_with('%')) return text.substr(0, text.size() > 1 && in_word(text[1]) ? 0 : 1);
  std::size_t length = 0;
  while (length < text.size() && in_word(text[length])) ++length;
  return text.substr(0, length);
}

/// `^` and a whole number that ends there, at the beginning of `text`: 2 of "^2", -1 of "^-1/s".
struct Exponent {
  int value = 1;
  std::size_t length = 0;  ///< 0: there is none
};
Exponent leading_exponent(std::string_view text) {
  if (!text.starts_with('^')) return {};
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 1, end, value);
  if (error != std::errc{} || value == 0 || std::abs(value) > 99) return {};
  const bool goes_on = stop != end && (in_word(*stop) || *stop == '.');
  if (goes_on) return {};
  return {value, static_cast<std::size_t>(stop - text.data())};
}

/// base · power(unit, exponent), or empty where an exponent leaves the range of Dimension.
std::optional<Unit> times_power(const Unit& base, const Unit& unit, int exponent) {
  bool in_range = true;
  const auto combine = [&](std::int8_t a, std::int8_t b) {
    const int sum = a + b * exponent;
    in_range = in_range && std::abs(sum) <= std::numeric_limits<std::int8_t>::max();
    return static_cast<std::int8_t>(in_range ? sum : 0);
  };
  const Dimension& a = base.dimension;
  const Dimension& b = unit.dimension;
  Unit result;
  result.dimension = {combine(a.length, b.length), combine(a.mass, b.mass), combine(a.time, b.time),
                      combine(a.angle, b.angle), combine(a.voltage, b.voltage)};
  result.exponent10 = base.exponent10 + unit.exponent10 * exponent;
  result.factor = base.factor;
  result.divisor = base.divisor;
  for (int i = 0; i < std::abs(exponent); ++i) {
    result.factor *= exponent > 0 ? unit.factor : unit.divisor;
    result.divisor *= exponent > 0 ? unit.divisor : unit.factor;
  }
  if (!in_range || !std::isnormal(result.factor) || !std::isnormal(result.divisor)) {
    return std::nullopt;
  }
  return result;
}

/// base times or by the power of a single unit at the beginning of `text`.
std::optional<UnitMatch> match_factor(std::string_view text, const Unit& base, bool divide) {
  const std::string_view word = leading_word(text);
  const auto found = std::ranges::find(kUnits, word, &NamedUnit::name);
  if (found == kUnits.end()) return std::nullopt;
  const Exponent exponent = leading_exponent(text.substr(word.size()));
  const auto unit = times_power(base, found->unit, divide ? -exponent.value : exponent.value);
  if (!unit) return std::nullopt;
  return UnitMatch{*unit, word.size() + exponent.length};
}

/// Goes on from a match with what is multiplied or divided after it.
UnitMatch with_further_factors(std::string_view text, UnitMatch match) {
  while (match.length < text.size()) {
    const char op = text[match.length];
    if (op != '*' && op != '/') break;
    const auto more = match_factor(text.substr(match.length + 1), match.unit, op == '/');
    if (!more) break;
    match = {more->unit, match.length + 1 + more->length};
  }
  return match;
}

/// Where the first digit that is not 0 stands: 123.4 → 3, 0.05 → -1; 0 for zero.
long magnitude(std::string_view mantissa) {
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t first = mantissa.find_first_not_of("0.");
  if (first == std::string_view::npos) return 0;
  const auto distance = static_cast<long>(point) - static_cast<long>(first);
  return first < point ? distance : distance + 1;
}

/// The number after `e`. Beyond a million the sign alone matters: no line has so many digits.
long exponent_value(std::string_view text) {
  constexpr long kHuge = 1'000'000;
  if (text.starts_with('+')) text.remove_prefix(1);
  long value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{}) value = text.starts_with('-') ? -kHuge : kHuge;
  return std::clamp(value, -kHuge, kHuge);
}

/// A factor that a row of digits can be multiplied by exactly, or 0.
std::uint64_t digit_factor(const Unit& unit) {
  constexpr double kMost = 1e9;  // [choice] a carry times ten is then far below 2^64
  const bool fits = unit.divisor == 1 && unit.factor <= kMost;
  return fits && unit.factor == std::trunc(unit.factor) ? static_cast<std::uint64_t>(unit.factor)
                                                        : 0;
}

/// The decimal number times a whole one, digit by digit.
std::string times(std::string_view decimal, std::uint64_t factor) {
  std::string product;
  std::uint64_t carry = 0;
  for (auto digit = decimal.rbegin(); digit != decimal.rend(); ++digit) {
    if (*digit == '.') {
      product += '.';
      continue;
    }
    carry += static_cast<std::uint64_t>(*digit - '0') * factor;
    product += static_cast<char>('0' + carry % 10);
    carry /= 10;
  }
  for (; carry > 0; carry /= 10) product += static_cast<char>('0' + carry % 10);
  std::ranges::reverse(product);
  return product;
}

/// "1.5", times ten to some power, times factor / divisor.
std::from_chars_result read_scaled(std::string_view mantissa, long exponent, const Unit& unit,
                                   double& value) {
  const std::uint64_t factor = digit_factor(unit);
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "{}e{}",
                 factor > 1 ? times(mantissa, factor) : std::string(mantissa), exponent);
  const char* const end = text.data() + text.size();
  if (factor > 0) return std::from_chars(text.data(), end, value);
  long double wide = 0;
  const auto result = std::from_chars(text.data(), end, wide);
  value = static_cast<double>(wide * unit.factor / unit.divisor);
  return result;
}

/// base^exponent, exactly as far as doubles reach.
constexpr double power_of(double base, int exponent) noexcept {
  double power = 1;
  for (; exponent > 0; --exponent) power *= base;
  return power;
}

constexpr double kDegree = std::numbers::pi / 180;  // rad

}  // namespace

std::optional<UnitMatch> match_unit(std::string_view text) {
  const auto first = match_factor(text, Unit{}, false);
  if (!first) return std::nullopt;
  return with_further_factors(text, *first);
}

std::optional<Unit> find_unit(std::string_view text) {
  const auto match = text.starts_with("1/") ? std::optional(with_further_factors(text, {Unit{}, 1}))
                                            : match_unit(text);
  if (!match || match->length != text.size()) return std::nullopt;
  return match->unit;
}

std::optional<double> quantity_of(std::string_view number, const Unit& unit) {
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  const std::string_view mantissa = number.substr(0, e);
  const long written = e < number.size() ? exponent_value(number.substr(e + 1)) : 0;
  const long exponent = written + unit.exponent10;
  double value = 0;
  const std::from_chars_result result = read_scaled(mantissa, exponent, unit, value);
  if (result.ec == std::errc::result_out_of_range) {
    if (magnitude(mantissa) + exponent > 0) return std::nullopt;
    value = 0;
  }
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

double number_in(const Unit& unit, double quantity) {
  const double shift = std::pow(10.0, std::abs(unit.exponent10));
  const double units = quantity / unit.factor * unit.divisor;
  return unit.exponent10 < 0 ? units * shift : units / shift;
}

double to_si(double quantity, Dimension dimension) noexcept {
  const double millis = power_of(1000, std::abs(dimension.length));
  const double degrees = power_of(kDegree, std::abs(dimension.angle));
  const double in_metres = dimension.length > 0 ? quantity / millis : quantity * millis;
  return dimension.angle < 0 ? in_metres / degrees : in_metres * degrees;
}

double from_si(double si, Dimension dimension) noexcept {
  if (dimension.length == 0 && dimension.angle == 0) return si;
  const Dimension inverse{.length = static_cast<std::int8_t>(-dimension.length),
                          .angle = static_cast<std::int8_t>(-dimension.angle)};
  const double near = to_si(si, inverse);
  // A value that was written with few digits comes back with them, although it has been rounded on
  // its way.
  constexpr double kRound = 1e9;       // [choice] far finer than any machine
  constexpr double kLastBits = 1e-15;  // [choice] four units in the last place, or a few more
  const double round = std::round(near * kRound) / kRound;
  return std::fabs(round - near) <= kLastBits * std::fabs(near) ? round + 0.0 : near;
}

std::string unit_text(Dimension dimension) {
  constexpr Dimension kStiffness{.mass = 1, .time = -2};
  if (dimension == kForce) return "N";
  if (dimension == kTorque) return "Nm";
  if (dimension == kStiffness) return "N/mm";
  if (dimension == kFrequency) return "Hz";
  if (dimension == kAngularAcceleration) return "deg/s^2";
  struct Factor {
    std::string_view name;
    int exponent;
  };
  const auto factors = std::to_array<Factor>({{"kg", dimension.mass},
                                              {"mm", dimension.length},
                                              {"deg", dimension.angle},
                                              {"s", dimension.time},
                                              {"V", dimension.voltage}});
  std::string text;
  for (const Factor& factor : factors) {
    if (factor.exponent <= 0) continue;
    text += fmt::format("{}{}", text.empty() ? "" : "*", factor.name);
    if (factor.exponent > 1) text += fmt::format("^{}", factor.exponent);
  }
  for (const Factor& factor : factors) {
    if (factor.exponent >= 0) continue;
    const int shown = text.empty() ? factor.exponent : -factor.exponent;
    text += fmt::format("{}{}", text.empty() ? "" : "/", factor.name);
    if (shown != 1) text += fmt::format("^{}", shown);
  }
  return text;
}

std::span<const std::string_view> unit_names() { return kUnitNames; }

std::string example_of(Dimension dimension) { return "5" + unit_text(dimension); }

}  // namespace rob::lang
