#pragma once

#include <string>

#include "lang/values/types.h"

namespace rob::lang {

/// A number as PRINT writes it: in the unit of unit_text(), with the fewest significant digits
/// which read back, as a literal with that unit, give the same bits: `20mm`, `1.5s`, `0.1`.
///
/// Exponents are written below 1e-5 and from 1e16 on: `1e-6`. Angles are not stored in degrees, so
/// some have no decimal in deg that gives the same bits; they are written with 17 digits. An angle
/// whose number of degrees is beyond a double is written in rad. -0 is written as 0.
/// `si` is in SI units and finite. Not for the tick.
std::string number_text(double si, Dimension dimension);

}  // namespace rob::lang
