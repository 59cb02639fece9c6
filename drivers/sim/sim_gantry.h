#pragma once

#include <vector>

#include "drivers/sim/pulse_drive.h"
#include "drivers/sim/sim_axis.h"
#include "drivers/sim/sim_machine.h"
#include "motion/servo/drive_data.h"

namespace rob::drivers {

struct SimGantryParameters {
  std::vector<motion::DriveData> drives;  ///< one an axis, at most motion::kMaxJoints
  motion::JointVector start;              ///< m, rad: where it stands at power-up
  std::vector<SimActuatorParameters> actuators;
  std::vector<PulseDrive> pulse_drives = {};  ///< one an axis; none: drives take forces
};

/// A gantry that is not there, or an arm as far as its drives go: independent servo axes with
/// inertia, friction, a motor limit and an encoder. SI. An arm's gravity, and what its axes do to
/// each other, are not in it (SimArm).
///
/// Each axis obeys m·q'' = u − b·q' − C·sign(q'), in closed form between calls, with the drive that
/// was last written (SimAxis). Without force friction brings the axes to rest. The force of drives
/// that take pulses changes with the speed: it is renewed every Encoder::kPeriod at least.
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
  void advance_sampled(std::int64_t count) noexcept override;
  void settle() noexcept override;
  void measure(motion::JointVector& q, motion::JointVector& qd) const noexcept override;

  void follow_pulses(double dt) noexcept;

  std::vector<SimAxis> axes_;
  std::vector<PulseDrive> pulse_drives_;
  bool follows_pulses_ = false;
};

}  // namespace rob::drivers
