#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/link/wire_backend.h"

namespace rob::drivers {

/// The [axis.wire] table of a robot file for one axis (docs/drivers.md). SI.
struct WiredAxis {
  std::string name;
  bool linear = true;
  double v_max = 0;
  int id = -1;        ///< of a servo on a bus; -1: the number of the axis, from 1
  int letter = -1;    ///< of grbl, X = 0; -1: that of the axis' name, or the next free one
  double travel = 0;  ///< m or rad per turn of a servo, or per mm of grbl; 0: not given
  double offset = 0;  ///< m or rad at the middle of a servo, or at the zero of grbl
  int direction = 1;  ///< -1: the machine counts the other way
};

/// A kind of machine on a wire: what `--backend NAME:PORT` opens.
struct Driver {
  const char* name;
  const char* description;
  int default_baud;
  bool sees_hand;  ///< it measures where a hand moves its axes
  /// Makes the machine, not yet open, with the axes of `axes`; those of `settings` are empty.
  /// Throws motion::DriverError for axes that this machine cannot have.
  std::unique_ptr<WireBackend> (*make)(WireSettings settings, std::span<const WiredAxis> axes);
};

/// All drivers. A new one gets one line in driver.cpp.
std::span<const Driver> drivers();
/// Null if no driver has that name.
const Driver* find_driver(std::string_view name);

// ---- helpers for `make`

/// An axis of the machine: `units` correspond to `travel` (m or rad), and the machine counts `zero`
/// at the offset of the robot file.
WireAxis axis_on(const WiredAxis& axis, double units, double travel, double zero);
/// Throws motion::DriverError if two axes have the same address; `what`: "id", "letter".
void refuse_same_address(const std::vector<WireAxis>& axes, const std::string& what);

}  // namespace rob::drivers
