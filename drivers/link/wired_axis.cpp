#include "drivers/link/wired_axis.h"

#include <cmath>

namespace rob::drivers {

WireAxis axis_on(const WiredAxis& axis, double units, double travel, double zero) {
  WireAxis wire;
  wire.name = axis.name;
  wire.scale = axis.direction * units / travel;
  wire.offset = axis.offset - zero / wire.scale;
  wire.most_step = axis.v_max * std::abs(wire.scale);
  return wire;
}

void refuse_same_address(const std::vector<WireAxis>& axes, const std::string& what) {
  for (std::size_t i = 0; i < axes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (axes[i].address == axes[k].address)
        throw motion::DriverError("axes " + axes[k].name + " and " + axes[i].name +
                                  " have the same " + what +
                                  " on the wire; write [axis.wire] in the robot file");
}

}  // namespace rob::drivers
