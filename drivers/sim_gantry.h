#pragma once

#include <cstdint>
#include <vector>

#include "drivers/sim_actuator.h"
#include "drivers/sim_axis.h"
#include "motion/servo/drive_data.h"
#include "motion/servo/servo_backend.h"
#include "motion/space/joint_vector.h"

namespace rob::drivers {

struct SimGantryParameters {
  std::vector<motion::DriveData> drives;  ///< one an axis, at most motion::kMaxJoints
  motion::JointVector start;              ///< m, rad: where it stands at power-up
  std::vector<SimActuatorParameters> actuators;
};

/// A gantry that is not there, or an arm as far as its drives go: independent servo axes with
/// inertia, friction, a motor limit and an encoder, and two-position actuators (lift, gripper) on
/// digital channels. SI. An arm's gravity, and what its axes do to each other, are not in it.
///
/// Each axis obeys m·q'' = u − b·q' − C·sign(q'), in closed form between calls, with the drive that
/// was last written (SimAxis). Positions are those of the encoder, velocities its estimate
/// (Encoder). Without force friction brings the axes to rest. The encoder counts without end: it
/// does not wrap. The same calls at the same times give the same bits.
///
/// The drives have a watchdog: kWatchdog after the last write() they brake and hold by themselves.
///
/// A measurement or a command costs a bounded number of steps, however long ago the last one was.
class SimGantry final : public motion::ServoBackend {
 public:
  /// s [choice] beyond the 200 ms that motion control makes up, so that it never cuts in on a run
  /// that goes on; at 20 mm/s an axis goes 5 mm in that time.
  static constexpr double kWatchdog = 0.25;

  /// Throws std::invalid_argument for numbers of axes that differ, or a channel beyond 63.
  explicit SimGantry(const SimGantryParameters& parameters);

  int axes() const noexcept override { return static_cast<int>(axes_.size()); }
  /// Powers up: standing at `start`, drives disabled, actuators at their OFF ends.
  void open() override;
  void close() noexcept override;
  motion::DriverStatus enable(double now) noexcept override;
  void disable(double now) noexcept override;
  motion::DriverStatus read(double now, motion::ServoState& state) noexcept override;
  motion::DriverStatus write(double now, const motion::ServoCommand& command) noexcept override;

  /// What was last written to an analog output, V.
  double analog_output(int channel) const noexcept {
    return analog_outputs_[static_cast<std::size_t>(channel)];
  }
  /// Where an axis really is, which no encoder tells: for tests and pictures.
  double true_position(int axis) const noexcept;

 private:
  void power_up() noexcept;
  void advance_to(double now) noexcept;
  void sample_to(double now) noexcept;
  void skip_to(double now) noexcept;
  void move_to(double now) noexcept;

  motion::JointVector start_;
  std::vector<SimAxis> axes_;
  std::vector<SimActuator> actuators_;
  motion::AnalogValues analog_outputs_{};
  bool started_ = false;  // the first call tells what time it is
  bool enabled_ = false;
  double time_ = 0;
  double written_ = 0;  // when the drives heard last
  double origin_ = 0;   // encoder sample k is taken at origin_ + k·Encoder::kPeriod
  std::int64_t samples_ = 0;
};

}  // namespace rob::drivers
