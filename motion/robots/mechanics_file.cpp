#include "motion/robots/mechanics_file.h"

#include <utility>

namespace rob::motion {

namespace {

// [choice] As wide as the drives' inertia and force (robot_file.cpp).
constexpr Range kLinkInertia{0, 1e6};
constexpr Range kRotorInertia{1e-9, 1e3};
constexpr Range kLinkTorque{0, 1e7};
constexpr Range kTorqueMax{1e-6, 1e7};
constexpr Range kGear{0.1, 1e4};
constexpr Range kEfficiency{0.1, 1};
constexpr Range kPayload{0, 1e3};
constexpr Range kFactor{0.1, 10};

GearedMotor read_motor(const TableReader& axis) {
  const TableReader motor =
      axis.table("motor", {"gear", "rotor_inertia", "efficiency", "torque_max"});
  const double gear = motor.number("gear", kGear);
  GearedMotor read;
  read.load_factor = 1 / motor.number("efficiency", kEfficiency);
  read.inertia = gear * gear * motor.quantity("rotor_inertia", Quantity::Inertia, kRotorInertia);
  read.torque_max = motor.quantity("torque_max", Quantity::Torque, kTorqueMax);
  return read;
}

}  // namespace

ArmMechanics read_mechanics(const TableReader& file, const std::vector<TableReader>& axes) {
  const TableReader table =
      file.table("dynamics", {"c0", "c1", "c2", "c3", "c4", "c5", "c6", "c7", "c8"});
  Ums7Parameters p;
  for (const auto& [key, value] : {std::pair{"c0", &p.c0},
                                   {"c1", &p.c1},
                                   {"c2", &p.c2},
                                   {"c3", &p.c3},
                                   {"c4", &p.c4},
                                   {"c5", &p.c5},
                                   {"c7", &p.c7},
                                   {"c8", &p.c8}}) {
    *value = table.quantity(key, Quantity::Inertia, kLinkInertia);
  }
  p.c6 = table.quantity("c6", Quantity::Torque, kLinkTorque);
  if (const char* fault = fault_of(p)) file.fail("dynamics", fault);
  ArmMechanics mechanics{Ums7Dynamics(p), {}};
  for (std::size_t i = 0; i < axes.size(); ++i) mechanics.motors.at(i) = read_motor(axes[i]);
  return mechanics;
}

SimulatedDeviation read_deviation(const TableReader& file) {
  SimulatedDeviation deviation;
  if (!file.has("simulation")) return deviation;
  const TableReader table = file.table("simulation", {"payload", "masses", "friction"});
  deviation.fixed = table.has("payload");
  if (deviation.fixed) deviation.payload = table.quantity("payload", Quantity::Mass, kPayload);
  if (table.has("masses")) deviation.masses = table.number("masses", kFactor);
  if (table.has("friction")) deviation.friction = table.number("friction", kFactor);
  return deviation;
}

}  // namespace rob::motion
