#include "motion/robots/wire_file.h"

#include <array>
#include <string_view>

namespace rob::motion {

namespace {

constexpr int kLeastBaud = 1200;
constexpr int kMostBaud = 4'500'000;
constexpr Range kWirePeriod{1e-3, 0.1};
constexpr int kMostId = 252;  // of a DYNAMIXEL servo
// [choice] From a fine screw to a belt wheel, from a gear of 1000 to a friction wheel.
constexpr Range kLengthTravel{1e-6, 10};
constexpr Range kAngleTravel{1e-3, 100};
constexpr Range kWireOffset{-100, 100};
constexpr Range kTurned{-1e3, 1e3};

constexpr std::array<std::string_view, 6> kLetters{"X", "Y", "Z", "A", "B", "C"};

WireAxisData read_axis(const TableReader& axis, AxisKind kind) {
  const bool linear = kind == AxisKind::Linear;
  const Quantity place = linear ? Quantity::Length : Quantity::Angle;
  const TableReader table = axis.table("wire", {"id", "letter", "travel", "offset", "direction"});
  WireAxisData wire;
  wire.id = table.integer_or("id", 0, kMostId, -1);
  if (table.has("letter")) wire.letter = table.choice("letter", {kLetters.begin(), kLetters.end()});
  if (table.has("travel"))
    wire.travel = table.quantity("travel", place, linear ? kLengthTravel : kAngleTravel);
  if (table.has("offset"))
    wire.offset = table.quantity("offset", place, linear ? kWireOffset : kTurned);
  wire.direction = table.integer_or("direction", -1, 1, 1);
  if (wire.direction == 0) table.fail("direction", "is 1, or -1 where the machine counts back");
  return wire;
}

}  // namespace

void read_wire(const TableReader& file, const std::vector<TableReader>& axes, RobotModel& robot) {
  if (file.has("wire")) {
    const TableReader table = file.table("wire", {"baud", "period"});
    robot.wire.baud = table.integer_or("baud", kLeastBaud, kMostBaud, 0);
    if (table.has("period"))
      robot.wire.period = table.quantity("period", Quantity::Time, kWirePeriod);
  }
  for (std::size_t i = 0; i < axes.size(); ++i)
    if (axes[i].has("wire")) robot.axes[i].wire = read_axis(axes[i], robot.axes[i].kind);
}

}  // namespace rob::motion
