#include "lang/values/number_text.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "lang/values/units.h"

namespace rob::lang {

namespace {

/// A positive decimal number: d.ddd · 10^exponent.
struct Decimal {
  std::string digits;  ///< the first is not 0
  int exponent = 0;
};

/// From what std::to_chars writes: "1.25e-06".
Decimal from_scientific(std::string_view text) {
  const std::size_t e = text.find('e');
  Decimal decimal;
  for (const char c : text.substr(0, e)) {
    if (c != '.') decimal.digits += c;
  }
  const char* first = text.data() + e + 1;
  if (*first == '+') ++first;
  std::from_chars(first, text.data() + text.size(), decimal.exponent);
  return decimal;
}

/// The fewest digits that are read back as `value`.
Decimal shortest(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.begin(), text.end(), value, std::chars_format::scientific);
  return from_scientific({text.data(), end.ptr});
}

std::string layout(const Decimal& decimal) {
  const std::string& digits = decimal.digits;
  const auto count = static_cast<int>(digits.size());
  if (decimal.exponent < -5 || decimal.exponent >= 16) {
    const std::string fraction = count > 1 ? "." + digits.substr(1) : "";
    return fmt::format("{}{}e{}", digits[0], fraction, decimal.exponent);
  }
  if (decimal.exponent < 0) {
    return "0." + std::string(static_cast<std::size_t>(-decimal.exponent - 1), '0') + digits;
  }
  const int whole = decimal.exponent + 1;
  if (whole >= count) return digits + std::string(static_cast<std::size_t>(whole - count), '0');
  const auto point = static_cast<std::size_t>(whole);
  return digits.substr(0, point) + "." + digits.substr(point);
}

}  // namespace

std::string number_text(double quantity, Dimension dimension) {
  assert(std::isfinite(quantity));
  const std::string unit_name = unit_text(dimension);
  if (quantity == 0) return "0" + unit_name;
  if (quantity < 0) return "-" + number_text(-quantity, dimension);
  const Unit unit = unit_name.empty() ? Unit{} : find_unit(unit_name).value();
  assert(unit.factor == 1 && unit.divisor == 1);
  Decimal decimal = shortest(quantity);
  decimal.exponent -= unit.exponent10;
  return layout(decimal) + unit_name;
}

std::string si_text(double si, Dimension dimension) {
  return number_text(from_si(si, dimension), dimension);
}

}  // namespace rob::lang
