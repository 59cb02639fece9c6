#include "tests/support/random_text.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

namespace rob::test {

std::string decimal(std::int64_t units, int decimals) {
  std::string digits = std::to_string(std::abs(units));
  if (decimals > 0) {
    const auto places = static_cast<std::size_t>(decimals);
    if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
    digits.insert(digits.size() - places, 1, '.');
    while (digits.back() == '0') digits.pop_back();
    if (digits.back() == '.') digits.pop_back();
  }
  return units < 0 ? "-" + digits : digits;
}

WrittenQuantity written_length(Choice& choice, int tenths_of_mm) {
  const double value = tenths_of_mm / 10.0;
  switch (choice.below(6)) {
    case 0:
    case 1:
      return {decimal(tenths_of_mm, 1), value};
    case 2:
      return {decimal(tenths_of_mm, 1) + "mm", value};
    case 3:
      return {decimal(tenths_of_mm, 2) + "cm", value};
    case 4:
      return {decimal(tenths_of_mm, 4) + "m", value};
    default:
      return {decimal(static_cast<std::int64_t>(tenths_of_mm) * 100, 0) + "um", value};
  }
}

WrittenQuantity written_angle(Choice& choice, int tenths_of_deg) {
  const double value = tenths_of_deg / 10.0;
  switch (choice.below(5)) {
    case 0:
    case 1:
      return {decimal(tenths_of_deg, 1), value};
    case 2:
      return {decimal(tenths_of_deg, 1) + "deg", value};
    case 3: {
      // Towards zero, so that a limit is not passed: 180° is 3.14159… rad.
      const auto thousandths = static_cast<std::int64_t>(value / 180 * std::numbers::pi * 1000);
      return {decimal(thousandths, 3) + "rad",
              static_cast<double>(thousandths) / 1000 * 180 / std::numbers::pi};
    }
    default: {
      const std::int64_t thousandths = tenths_of_deg / 36 * 10;  // whole hundredths of a turn
      return {decimal(thousandths, 3) + "rev", static_cast<double>(thousandths) * 0.36};
    }
  }
}

WrittenQuantity written_time(Choice& choice, int tenths_of_s) {
  const double value = tenths_of_s / 10.0;
  switch (choice.below(4)) {
    case 0:
      return {decimal(static_cast<std::int64_t>(tenths_of_s) * 100, 0) + "ms", value};
    case 1:
      return {decimal(static_cast<std::int64_t>(tenths_of_s) * 100'000, 0) + "us", value};
    case 2:  // a thousandth of a minute is 0.06 s
      return {decimal(tenths_of_s / 6 * 10, 3) + "min", tenths_of_s / 6 * 0.6};
    default:
      return {decimal(tenths_of_s, 1) + "s", value};
  }
}

}  // namespace rob::test
