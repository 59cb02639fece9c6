#pragma once

#include <vector>

#include "drivers/sim_axis.h"
#include "drivers/sim_machine.h"
#include "motion/servo/drive_data.h"

namespace rob::drivers {

struct SimGantryParameters {
  std::vector<motion::DriveData> drives;  ///< one an axis, at most motion::kMaxJoints
  motion::JointVector start;              ///< m, rad: where it stands at power-up
  std::vector<SimActuatorParameters> actuators;
};

/// A gantry that is not there, or an arm as far as its drives go: independent servo axes with
/// inertia, friction, a motor limit and an encoder. SI. An arm's gravity, and what its axes do to
/// each other, are not in it (SimArm).
///
/// Each axis obeys m·q'' = u − b·q' − C·sign(q'), in closed form between calls, with the drive that
/// was last written (SimAxis). Without force friction brings the axes to rest.
class SimGantry final : public SimMachine {
 public:
  /// Throws std::invalid_argument for numbers of axes that differ, or a channel beyond 63.
  explicit SimGantry(const SimGantryParameters& parameters);

  double true_position(int axis) const noexcept override {
    return axes_[static_cast<std::size_t>(axis)].q();
  }

 private:
  void place(const motion::JointVector& q) noexcept override;
  void push(const motion::JointVector& drive) noexcept override;
  void hold() noexcept override;
  void release() noexcept override;
  void advance(double dt) noexcept override;
  void sample() noexcept override;
  void settle() noexcept override;
  void measure(motion::JointVector& q, motion::JointVector& qd) const noexcept override;

  std::vector<SimAxis> axes_;
};

}  // namespace rob::drivers
