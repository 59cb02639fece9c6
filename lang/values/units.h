#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lang/values/dimension.h"

/// The units of the language and the conversion of written numbers to quantities.
///
/// The language keeps a quantity in mm, kg, s, deg and V and in products and powers of them. So
/// what people write is exact: 100mm - 10mm is 90mm. A Machine takes SI units: to_si().
///
/// A unit is one of the table (um mm cm m in, deg rad rev rpm, us ms s min h, N kN, Nm, g kg, Hz,
/// V, %), or a product or quotient of these and of powers of them: `mm/s^2`, `N*m`, `mm^-1`. Units
/// are case-sensitive. Not for the tick, apart from to_si() and from_si().
namespace rob::lang {

/// quantity = number · 10^exponent10 · factor / divisor. The power of ten is kept apart because it
/// can be applied to the digits before they are rounded: 0.009m is the double nearest to 9.
struct Unit {
  Dimension dimension;
  int exponent10 = 0;
  double factor = 1;
  double divisor = 1;
};

struct UnitMatch {
  Unit unit;
  std::size_t length = 0;  ///< bytes of the text that belong to the unit
};

/// The longest unit at the beginning of `text` after which no letter, digit or _ follows.
std::optional<UnitMatch> match_unit(std::string_view text);

/// The unit that the whole of `text` names; `1/unit` is one here. Blanks are not allowed.
std::optional<Unit> find_unit(std::string_view text);

/// The quantity that a written number (digits [. digits] [e [sign] digits]) in a unit stands for:
/// the double nearest to it, but for units with rad or with a divisor, where the last bit may
/// differ. Empty if it is beyond the range of a double; what is too small for one becomes 0.
std::optional<double> quantity_of(std::string_view number, const Unit& unit);

/// How many of a unit a quantity is; may leave the range of a double.
double number_in(const Unit& unit, double quantity);

/// A quantity in SI units: 16.3 (mm) is 0.0163 (m).
double to_si(double quantity, Dimension dimension) noexcept;
/// The quantity of which that is the SI value, with the few digits (up to 1e-9 mm or deg) that it
/// was written with, if one of these is within rounding errors.
double from_si(double si, Dimension dimension) noexcept;

/// The unit in which values of a dimension are written: "mm/s", "deg", "kg*mm"; empty for a plain
/// number. find_unit() reads it back.
std::string unit_text(Dimension dimension);
/// "5mm", an example of a value of a dimension, for remedies.
std::string example_of(Dimension dimension);

/// The single units of the table, for suggestions.
std::span<const std::string_view> unit_names();

}  // namespace rob::lang
