#pragma once

#include <cstdint>

#include "motion/generate/axis_brake.h"
#include "motion/robots/robot_model.h"
#include "motion/servo/servo_backend.h"

namespace rob::runtime {

/// Whether anything is known of the machine. If the servo loses touch with it, references no longer
/// count: where the machine is found again it is braked to rest. Every call but the constructor may
/// be used in the tick; all times in s.
class Touch {
 public:
  explicit Touch(const motion::RobotModel& robot);

  bool kept() const noexcept { return state_ == State::Kept; }
  bool lost() const noexcept { return state_ == State::Lost; }
  bool braked() const noexcept { return state_ == State::Braked; }

  /// `gap`: how long nobody has looked after the machine.
  void lose(double now, double gap) noexcept;
  double gap() const noexcept { return gap_; }
  /// Whether this says where the machine was after the gap.
  bool finds(const motion::ServoState& state) const noexcept;
  /// It stands at `found`, and moves with `velocity`; from there the axes brake.
  void brake(motion::JointReference found, const motion::JointVector& velocity) noexcept;
  /// While braked(): where the axes have to be.
  motion::JointReference at(double instant) const noexcept { return brake_.at(instant); }

 private:
  enum class State : std::uint8_t {
    Kept,   ///< the references are followed
    Lost,   ///< nothing is known of the machine since lost_
    Braked  ///< it was found, and is braked by brake_
  };

  State state_ = State::Kept;
  double lost_ = 0;  ///< when the gap ended
  double gap_ = 0;
  motion::JointVector v_max_;
  motion::AxisBrake brake_;
};

}  // namespace rob::runtime
