#pragma once

#include <string>

#include "lang/values/types.h"

namespace rob::lang {

/// A quantity as PRINT writes it: in the unit of unit_text(), with the fewest significant digits
/// which read back, as a literal with that unit, give the same bits: `20mm`, `1.5s`, `0.1`.
///
/// Exponents are written below 1e-5 and from 1e16 on: `1e-6`. -0 is written as 0. `quantity` is as
/// the language keeps it (units.h), and finite. Not for the tick.
std::string number_text(double quantity, Dimension dimension);
/// The same of a value in SI units.
std::string si_text(double si, Dimension dimension);

}  // namespace rob::lang
