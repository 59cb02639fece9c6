#pragma once

#include <cstdint>

#include "motion/cell/cell_data.h"

namespace rob::drivers {

/// Another cell of the same kind: what CellData::spread names is drawn evenly from its ranges, the
/// side error of each hole that has one evenly from the disc of hole_error, and noise begins at
/// `seed`. The same seed is the same cell, on every machine. Without a spread only noise is
/// another.
motion::CellData drawn_cell(const motion::CellData& cell, std::uint64_t seed);

}  // namespace rob::drivers
