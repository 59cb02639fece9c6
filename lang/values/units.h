#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lang/values/dimension.h"

/// The units of the language and the conversion of written numbers to SI.
///
/// A unit is one of the table (um mm cm m in, deg rad rev rpm, us ms s min, N kN, Nm, g kg, Hz, V,
/// %), or a product or quotient of these and of powers of them: `mm/s^2`, `N*m`, `mm^-1`. Units
/// are case-sensitive. Not for the tick.
namespace rob::lang {

/// SI value = number · 10^exponent10 · factor. The power of ten is kept apart because it can be
/// applied to the digits before they are rounded: 9mm is the double nearest to 0.009, which
/// 9 · 0.001 is not.
struct Unit {
  Dimension dimension;
  int exponent10 = 0;
  double factor = 1;
};

struct UnitMatch {
  Unit unit;
  std::size_t length = 0;  ///< bytes of the text that belong to the unit
};

/// The longest unit at the beginning of `text` after which no letter, digit or _ follows.
std::optional<UnitMatch> match_unit(std::string_view text);

/// The unit that the whole of `text` names; `1/unit` is one here. Blanks are not allowed.
std::optional<Unit> find_unit(std::string_view text);

/// The SI value of a written number (digits [. digits] [e [sign] digits]) in a unit. Empty if it
/// is beyond the range of a double; what is too small for one becomes 0.
std::optional<double> to_si(std::string_view number, const Unit& unit);

/// The unit in which values of a dimension are written: "mm/s", "deg", "kg*mm"; empty for a plain
/// number. find_unit() reads it back.
std::string unit_text(Dimension dimension);
/// "5mm", an example of a value of a dimension, for remedies.
std::string example_of(Dimension dimension);

/// The single units of the table, for suggestions.
std::span<const std::string_view> unit_names();

}  // namespace rob::lang
