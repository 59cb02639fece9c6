#pragma once

#include <cstdint>
#include <vector>

#include "drivers/sim/sim_actuator.h"
#include "motion/servo/servo_backend.h"
#include "motion/space/joint_vector.h"

namespace rob::drivers {

/// The parts that every simulated machine has: time that passes between calls, encoders that are
/// sampled meanwhile, drives with a watchdog, and two-position actuators (lift, gripper) on digital
/// channels. How the axes move is said by the class that is derived. SI.
///
/// Positions are those of the encoder, velocities its estimate (Encoder). The encoder counts
/// without end: it does not wrap. The same calls at the same times give the same bits.
///
/// The drives have a watchdog: kWatchdog after the last write() they brake and hold by themselves.
///
/// A measurement or a command costs a bounded number of steps, however long ago the last one was.
class SimMachine : public motion::ServoBackend {
 public:
  /// s [choice] beyond the 200 ms that motion control makes up, so that it never cuts in on a run
  /// that goes on; at 20 mm/s an axis goes 5 mm in that time.
  static constexpr double kWatchdog = 0.25;

  int axes() const noexcept override { return static_cast<int>(start_.size()); }
  /// Powers up: standing at `start`, drives disabled, actuators at their OFF ends.
  void open() override;
  void close() noexcept override;
  motion::DriverStatus enable(double now) noexcept override;
  void disable(double now) noexcept override;
  motion::DriverStatus read(double now, motion::ServoState& state) noexcept override;
  motion::DriverStatus write(double now, const motion::ServoCommand& command) noexcept override;

  /// The voltage that was last written to an analog output, V.
  double analog_output(int channel) const noexcept {
    return analog_outputs_[static_cast<std::size_t>(channel)];
  }
  /// Where an axis really is, which no encoder shows: for tests and pictures.
  virtual double true_position(int axis) const noexcept = 0;

 protected:
  /// Throws std::invalid_argument for a channel beyond 63. The derived class calls open() when its
  /// axes are made.
  SimMachine(const motion::JointVector& start, const std::vector<SimActuatorParameters>& actuators);

  // The axes; all may be used in the tick.
  virtual void place(const motion::JointVector& q) noexcept = 0;  ///< standing, without force
  virtual void push(const motion::JointVector& drive) noexcept = 0;
  /// Takes the load that the program has declared. It is called before each push().
  virtual void carry(const motion::CarriedLoad* /*carried*/) noexcept {}
  virtual void hold() noexcept = 0;     ///< brake with all force, then hold
  virtual void release() noexcept = 0;  ///< the drives have no force
  virtual void advance(double dt) noexcept = 0;
  virtual void sample() noexcept = 0;  ///< the encoders' sample, every Encoder::kPeriod
  /// `count` whole periods of the encoders, with a sample at the end of each.
  virtual void advance_sampled(std::int64_t count) noexcept;
  virtual void settle() noexcept = 0;  ///< the encoders', after a time without samples
  virtual void measure(motion::JointVector& q, motion::JointVector& qd) const noexcept = 0;

 private:
  void advance_to(double now) noexcept;
  void sample_to(double now) noexcept;
  void skip_to(double now) noexcept;
  void move_to(double now) noexcept;
  double sample_instant(std::int64_t number) const noexcept;

  motion::JointVector start_;
  std::vector<SimActuator> actuators_;
  motion::AnalogValues analog_outputs_{};
  bool started_ = false;  // the first call gives the time
  bool enabled_ = false;
  double time_ = 0;
  double written_ = 0;  // when the drives heard last
  double origin_ = 0;   // encoder sample k is taken at origin_ + k·Encoder::kPeriod
  std::int64_t samples_ = 0;
};

}  // namespace rob::drivers
