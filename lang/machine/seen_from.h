#pragma once

#include <span>

#include "lang/machine/reading.h"
#include "lang/values/arithmetic.h"
#include "lang/values/dimension.h"
#include "lang/values/setting.h"

namespace rob::lang {

/// Turns a force sensor's reading along the axes of the world into the program's reading: along
/// those of the setting's frame, or, IN TOOL, of the tool as it stands; `tool` is its pose in the
/// world. Other readings stay. May be used in the tick.
void turn_into_frame(Reading what, const Setting& setting, const PoseValue& tool, Slot* value);

/// From SI, as the world gives a reading, to the units of the language. `axes`: those of the
/// robot's axes. May be used in the tick.
void read_in_units(Reading what, std::span<const Dimension> axes, Slot* value) noexcept;

}  // namespace rob::lang
