#pragma once

#include <cstdint>

#include "runtime/run/controller.h"
#include "runtime/time/clock.h"

namespace rob::runtime {

/// So many instructions without a wait also take one cycle of virtual time (docs/language.md).
inline constexpr std::int64_t kInstructionsPerCycle = 1'000'000;

/// A robot under control on the virtual clock: one thread steps servo and motion, cycle by cycle.
class Stepper {
 public:
  /// Enables the robot.
  explicit Stepper(Controller& controller);

  /// The next cycle of motion, and the servo's before it.
  void cycle();
  /// The servo's cycles up to the instant of the next cycle of motion, that one's own included.
  void servo_cycles();
  double now() const { return clock_.now(); }

 private:
  Controller& controller_;
  VirtualClock clock_;
  std::int64_t next_ = 0;        ///< cycle of motion
  std::int64_t next_servo_ = 0;  ///< cycle of the servo
};

}  // namespace rob::runtime
