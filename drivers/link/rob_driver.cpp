#include "drivers/link/rob_driver.h"

#include <utility>

#include "base/unit_factors.h"
#include "drivers/link/rob_link.h"

namespace rob::drivers {

std::unique_ptr<WireBackend> make_rob(WireSettings settings, std::span<const WiredAxis> axes) {
  constexpr double kMicro = 1e6;  // units in a millimetre, or a degree
  for (const WiredAxis& axis : axes)
    settings.axes.push_back(axis_on(axis, kMicro, axis.linear ? kMillimetre : kDegree, 0));
  auto link = rob_link(settings.axes, settings.period, settings.baud);
  return std::make_unique<WireBackend>(std::move(settings), std::move(link));
}

}  // namespace rob::drivers
