#include "drivers/link/servo_driver.h"

#include <utility>

#include "base/unit_factors.h"
#include "drivers/link/dynamixel_dialect.h"
#include "drivers/link/feetech_dialect.h"
#include "drivers/link/servo_link.h"

namespace rob::drivers {

using motion::DriverError;

namespace {

constexpr double kTurn = 4096;     // ticks a turn, of both makers
constexpr double kScsTurn = 1024;  // ticks of the way of a servo of Feetech's SCS series

WireAxis servo_axis(const WiredAxis& axis, int number, double ticks) {
  const bool turns = !axis.linear && ticks == kTurn;
  const double travel = axis.travel != 0 ? axis.travel : turns ? kFullTurn : 0;
  if (travel == 0)
    throw DriverError("the robot file does not say how far axis " + axis.name +
                      " goes in a turn of its servo (SCS: over its 1024 places); write [axis.wire]"
                      " travel = \"" +
                      (axis.linear ? "40 mm" : "300 deg") + "\" there");
  WireAxis wire = axis_on(axis, ticks, travel, ticks / 2);
  wire.address = axis.id >= 0 ? axis.id : number;
  return wire;
}

using MakeLink = std::unique_ptr<WireLink> (*)(const std::vector<WireAxis>& axes, int baud);

std::unique_ptr<WireBackend> make_servos(WireSettings settings, std::span<const WiredAxis> axes,
                                         double ticks, MakeLink make) {
  for (std::size_t i = 0; i < axes.size(); ++i)
    settings.axes.push_back(servo_axis(axes[i], static_cast<int>(i) + 1, ticks));
  refuse_same_address(settings.axes, "id");
  auto link = make(settings.axes, settings.baud);
  return std::make_unique<WireBackend>(std::move(settings), std::move(link));
}

}  // namespace

std::unique_ptr<WireLink> dynamixel_link(const std::vector<WireAxis>& axes, int baud) {
  return std::make_unique<ServoLink<DynamixelDialect>>(axes, baud);
}

std::unique_ptr<WireLink> feetech_link(const std::vector<WireAxis>& axes, int baud) {
  return std::make_unique<ServoLink<FeetechDialect>>(axes, baud);
}

std::unique_ptr<WireLink> feetech_scs_link(const std::vector<WireAxis>& axes, int baud) {
  return std::make_unique<ServoLink<FeetechScsDialect>>(axes, baud);
}

std::unique_ptr<WireBackend> make_dynamixel(WireSettings settings,
                                            std::span<const WiredAxis> axes) {
  return make_servos(std::move(settings), axes, kTurn, dynamixel_link);
}

std::unique_ptr<WireBackend> make_feetech(WireSettings settings, std::span<const WiredAxis> axes) {
  return make_servos(std::move(settings), axes, kTurn, feetech_link);
}

std::unique_ptr<WireBackend> make_feetech_scs(WireSettings settings,
                                              std::span<const WiredAxis> axes) {
  return make_servos(std::move(settings), axes, kScsTurn, feetech_scs_link);
}

}  // namespace rob::drivers
