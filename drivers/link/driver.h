#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/link/wire_backend.h"

namespace rob::drivers {

/// What a robot file says about one axis on a wire ([axis.wire], docs/drivers.md). SI.
struct WiredAxis {
  std::string name;
  bool linear = true;
  double v_max = 0;
  int id = -1;        ///< of a servo on a bus; -1: the number of the axis, from 1
  int letter = -1;    ///< of grbl, X = 0; -1: that of the axis' name, or the next that is free
  double travel = 0;  ///< m or rad for a turn of a servo, or for 1 mm of grbl; 0: left out
  double offset = 0;  ///< m or rad where a servo stands in its middle, or grbl at its zero
  int direction = 1;  ///< -1: it counts the other way
};

/// A kind of machine on a wire: what `--backend NAME:PORT` opens.
struct Driver {
  const char* name;
  const char* description;
  int default_baud;
  bool sees_hand;  ///< it knows where a hand has moved its axes
  /// The machine, not yet open. `settings` has no axes yet; they come from `axes`. Throws
  /// motion::DriverError for axes that this machine cannot have.
  std::unique_ptr<WireBackend> (*make)(WireSettings settings, std::span<const WiredAxis> axes);
};

/// All that there are. A new driver gets one line in driver.cpp.
std::span<const Driver> drivers();
/// Null where there is none of that name.
const Driver* find_driver(std::string_view name);

// ---- for those who write a `make`

/// An axis of the machine: `units` of it are `travel` (m or rad), and it counts `zero` where the
/// robot file's offset is.
WireAxis axis_on(const WiredAxis& axis, double units, double travel, double zero);
/// Throws motion::DriverError if two axes have the same address; `what`: "id", "letter".
void refuse_same_address(const std::vector<WireAxis>& axes, const std::string& what);

}  // namespace rob::drivers
