#pragma once

#include <array>

#include "motion/dynamics/arm_load.h"
#include "motion/dynamics/ums7_dynamics.h"

namespace rob::motion {

/// A motor with its gear, as its axis feels it. All that it gives and takes is counted at the axis,
/// in Nm. S2's motor terms: u = load_factor·P + inertia·q'' + viscous friction·q' for a torque P at
/// the axis.
struct GearedMotor {
  double load_factor = 1;  ///< S2's Da: 1/efficiency of the gear
  double inertia = 0;      ///< S2's Db: of the rotor times the gear's ratio squared, kg·m²
  double torque_max = 0;   ///< greatest P that the gear bears, Nm
};

/// All that is known of an arm's mechanics but its friction, which is the drives'.
struct ArmMechanics {
  Ums7Dynamics dynamics;
  std::array<GearedMotor, Ums7Dynamics::kAxes> motors;
  ArmLengths lengths{};

  /// The same arm with something at its flange.
  ArmMechanics carrying(const ArmLoad& load) const noexcept {
    return {Ums7Dynamics(with_load(dynamics.parameters(), load, lengths)), motors, lengths};
  }
  /// The dynamics of what it carries alone, without the arm.
  Ums7Dynamics load_alone(const ArmLoad& load) const noexcept {
    return Ums7Dynamics(with_load({}, load, lengths));
  }
};

}  // namespace rob::motion
