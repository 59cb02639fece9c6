#pragma once

#include <array>
#include <vector>

#include "drivers/sim/encoder.h"
#include "drivers/sim/sim_machine.h"
#include "motion/dynamics/arm_mechanics.h"
#include "motion/servo/drive_data.h"

namespace rob::drivers {

/// The arm as it really is. The servo counts with mechanics of its own, those of the robot file: a
/// payload or a wrong coefficient (motion::with_payload, motion::scaled) is put in here alone.
/// Where nothing of the kind is wanted the arm may carry what the program says that it does.
struct SimArmParameters {
  std::vector<motion::DriveData> drives;  ///< six
  motion::ArmMechanics mechanics;
  motion::JointVector start;  ///< rad
  std::vector<SimActuatorParameters> actuators;
  double friction = 1;                   ///< factor of all friction
  bool carries_what_it_is_told = false;  ///< beside what is in `mechanics`
};

/// An arm that is not there: S2's table with its complete mechanics, and motors with gears.
///
///     Da·(H(q)·q'' + Coriolis torques + ∂V/∂q) + Db·q'' = u − Dc·q' − C·sign(q')
///
/// with |u| <= force_max. The smooth part is integrated in steps of at most Encoder::kPeriod by
/// Runge and Kutta's fourth-order method; Coulomb friction then brakes each axis by at most C·h,
/// all six together, as a free step demands (Moreau's time stepping): at rest an axis stays
/// exactly where it is until more than C pulls at it. Standing brakes close when the drives have no
/// force, for otherwise the arm would fall.
class SimArm final : public SimMachine {
 public:
  /// Throws std::invalid_argument unless there are six drives and six start values, or for a
  /// channel beyond 63.
  explicit SimArm(const SimArmParameters& parameters);

  double true_position(int axis) const noexcept override { return q_[axis]; }

 private:
  void place(const motion::JointVector& q) noexcept override;
  void push(const motion::JointVector& drive) noexcept override;
  void carry(const motion::CarriedLoad* carried) noexcept override;
  void hold() noexcept override;
  void release() noexcept override { hold(); }
  void advance(double dt) noexcept override;
  void sample() noexcept override;
  void settle() noexcept override;
  void measure(motion::JointVector& q, motion::JointVector& qd) const noexcept override;

  motion::ArmInertia inertia(const motion::JointVector& q) const noexcept;
  motion::JointVector acceleration(const motion::JointVector& q,
                                   const motion::JointVector& v) const noexcept;
  void step(double h) noexcept;
  void step_smoothly(double h) noexcept;
  void brake(const motion::JointVector& from, const motion::JointVector& v_from, double h) noexcept;

  motion::ArmMechanics bare_;
  const motion::CarriedLoad* carried_ = nullptr;
  bool carries_what_it_is_told_;
  motion::Ums7Dynamics dynamics_;  ///< of both
  // Per axis, as the link feels it, all divided by Da.
  motion::JointVector load_factor_;
  motion::JointVector rotor_;
  motion::JointVector viscous_;
  motion::JointVector coulomb_;
  motion::JointVector force_max_;
  std::vector<Encoder> encoders_;
  motion::JointVector q_, v_, u_;
  bool holding_ = false;
};

}  // namespace rob::drivers
