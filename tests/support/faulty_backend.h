#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "motion/servo/servo_backend.h"

namespace rob::test {

/// A machine with one thing wrong with it, from a given instant on; healthy before. It passes on
/// what it does not spoil to the machine that it wraps. SI.
class FaultyBackend final : public motion::ServoBackend {
 public:
  enum class Fault : std::uint8_t {
    None,
    LockedJoint,     ///< the axis gives no more than its transmission's elasticity
    FrozenEncoder,   ///< the axis moves, its encoder counts no more
    JumpingEncoder,  ///< from now on the encoder is off by a constant amount
    NotANumber,      ///< the position is NaN
    Silent,          ///< no answer, nothing arrives; the last drive stays
    Lost             ///< the wire is cut
  };

  static constexpr double kStiffness = 2e5;  ///< N/m or Nm/rad: a toothed belt of half a metre
  static constexpr double kCount = 1e-6;     ///< m or rad, of the locked joint's encoder
  static constexpr double kJump = 0.01;      ///< m or rad, unless told otherwise

  explicit FaultyBackend(motion::ServoBackend& machine) : machine_(machine) {}

  void inject(Fault fault, double from, int axis = 0, double jump = kJump) noexcept {
    fault_ = fault;
    jump_ = jump;
    from_ = from;
    axis_ = axis;
    caught_ = false;
  }

  int axes() const noexcept override { return machine_.axes(); }
  void open() override { machine_.open(); }
  void close() noexcept override { machine_.close(); }
  motion::DriverStatus enable(double now) noexcept override {
    const motion::DriverStatus status = answer(now);
    return status == motion::DriverStatus::Ok ? machine_.enable(now) : status;
  }
  void disable(double now) noexcept override { machine_.disable(now); }

  motion::DriverStatus read(double now, motion::ServoState& state) noexcept override {
    if (const auto status = answer(now); status != motion::DriverStatus::Ok) return status;
    const motion::DriverStatus status = machine_.read(now, state);
    if (now >= from_) spoil(state.measured);
    return status;
  }

  motion::DriverStatus write(double now, const motion::ServoCommand& command) noexcept override {
    if (const auto status = answer(now); status != motion::DriverStatus::Ok) return status;
    motion::ServoCommand passed = command;
    if (now >= from_ && fault_ == Fault::LockedJoint) {
      give_ = std::nearbyint(command.drive[axis_] / kStiffness / kCount) * kCount;
      passed.drive[axis_] = 0;
    }
    return machine_.write(now, passed);
  }

 private:
  motion::DriverStatus answer(double now) const noexcept {
    if (now < from_) return motion::DriverStatus::Ok;
    if (fault_ == Fault::Silent) return motion::DriverStatus::Silent;
    if (fault_ == Fault::Lost) return motion::DriverStatus::Lost;
    return motion::DriverStatus::Ok;
  }

  void spoil(motion::JointMeasurement& measured) noexcept {
    double& q = measured.q[axis_];
    if (!caught_) {
      caught_ = true;
      stuck_at_ = q;
      give_ = 0;
    }
    switch (fault_) {
      case Fault::LockedJoint:
        q = stuck_at_ + give_;
        measured.qd[axis_] = 0;
        break;
      case Fault::FrozenEncoder:
        q = stuck_at_;
        measured.qd[axis_] = 0;
        break;
      case Fault::JumpingEncoder:
        q += jump_;
        break;
      case Fault::NotANumber:
        q = std::numeric_limits<double>::quiet_NaN();
        break;
      case Fault::None:
      case Fault::Silent:
      case Fault::Lost:
        break;
    }
  }

  motion::ServoBackend& machine_;
  Fault fault_ = Fault::None;
  double from_ = 0;
  double jump_ = kJump;
  int axis_ = 0;
  bool caught_ = false;  // the fault has shown itself
  double stuck_at_ = 0;
  double give_ = 0;
};

}  // namespace rob::test
