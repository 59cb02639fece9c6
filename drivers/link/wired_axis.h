#pragma once

#include <string>
#include <vector>

#include "drivers/link/wire_link.h"

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

/// An axis of the machine: `units` correspond to `travel` (m or rad), and the machine counts `zero`
/// at the offset of the robot file.
WireAxis axis_on(const WiredAxis& axis, double units, double travel, double zero);
/// Throws motion::DriverError if two axes have the same address; `what`: "id", "letter".
void refuse_same_address(const std::vector<WireAxis>& axes, const std::string& what);

}  // namespace rob::drivers
