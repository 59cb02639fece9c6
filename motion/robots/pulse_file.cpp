#include "motion/robots/pulse_file.h"

#include <algorithm>
#include <cstdio>

namespace rob::motion {
namespace {

// [choice] As wide as an encoder's count and a drive's friction and force (robot_file.cpp).
constexpr Range kPulse{1e-10, 1e-2};
constexpr Range kSpeedStiffness{1e-9, 1e6};
constexpr Range kRipple{0, 1e5};
constexpr Range kRipplePeriod{1e-6, 10};

// s. Four steps of 250 us, in which the simulation computes such a drive. [choice] Real ones take
// 5 ms and more to reach their speed.
constexpr double kFastest = 1e-3;

double time_constant(const Axis& axis) {
  return axis.drive.inertia / (axis.pulses.speed_stiffness + axis.drive.viscous_friction);
}

PulseDriveData read_pulse_drive(const TableReader& axis, AxisKind kind) {
  const bool linear = kind == AxisKind::Linear;
  const Quantity place = linear ? Quantity::Length : Quantity::Angle;
  const TableReader table =
      axis.table("pulse_drive", {"pulse", "speed_stiffness", "ripple", "ripple_period"});
  PulseDriveData drive;
  drive.pulse = table.quantity("pulse", place, kPulse);
  drive.speed_stiffness =
      table.quantity("speed_stiffness",
                     linear ? Quantity::LinearFriction : Quantity::RotaryFriction, kSpeedStiffness);
  drive.ripple = table.quantity("ripple", linear ? Quantity::Force : Quantity::Torque, kRipple);
  drive.ripple_period = table.quantity("ripple_period", place, kRipplePeriod);
  return drive;
}

/// A drive that counts pulses itself lags them by v/kp.
void check_lag(const TableReader& table, const Axis& axis) {
  const double kp =
      (1 + axis.drive.viscous_friction / axis.pulses.speed_stiffness) / (4 * time_constant(axis));
  const double lag = axis.v_max / kp;
  if (lag <= axis.drive.following_limit) return;
  const bool linear = axis.kind == AxisKind::Linear;
  char text[96];
  std::snprintf(text, sizeof text, "%.3g %s late at v_max, beyond following_limit", lag,
                linear ? "m" : "rad");
  table.fail("v_max", "under \"pulse_train\" the axis is " + std::string(text) +
                          "; lower it, or close the loop");
}

}  // namespace

void read_servo(const TableReader& file, const std::vector<TableReader>& axes, RobotModel& robot) {
  if (file.has("servo")) {
    robot.servo = static_cast<ServoStructure>(
        file.choice("servo", {"force", "pulse_train", "position_loop", "double_loop"}));
  }
  const bool forces = robot.servo == ServoStructure::Force;
  if (!forces && robot.mechanics)
    file.fail("servo", "[dynamics] is fed forward as forces; leave servo out, or [dynamics]");
  for (std::size_t i = 0; i < axes.size(); ++i) {
    Axis& axis = robot.axes[i];
    if (forces && axes[i].has("pulse_drive"))
      axes[i].fail("pulse_drive",
                   "belongs to a servo that sends pulses, as servo = \"double_loop\"");
    if (forces) continue;
    axis.pulses = read_pulse_drive(axes[i], axis.kind);
    if (time_constant(axis) < kFastest)
      axes[i].fail("pulse_drive",
                   "reaches its speed within 1 ms, which is not simulated; lower "
                   "speed_stiffness");
    if (robot.servo == ServoStructure::PulseTrain) check_lag(axes[i], axis);
  }
}

}  // namespace rob::motion
