#pragma once

#include "motion/dynamics/arm_load.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// Closes the loop: makes what the drives take, every servo cycle, out of where the axes shall be
/// and where they are. Every call may be used in the tick.
class Servo {
 public:
  virtual ~Servo() = default;

  /// At enable: nothing accumulated, time counts from `now`.
  virtual void reset(double now) noexcept = 0;

  /// Reference and measurement of the same instant `now`, which never goes back. Forces in N or Nm,
  /// or whole pulses for the coming cycle.
  virtual JointVector update(double now, const JointReference& reference,
                             const JointMeasurement& measured) noexcept = 0;

  /// From the next update() on the arm carries that.
  virtual void carry(const ArmLoad& /*load*/) noexcept {}

  /// κ = the greatest share of what the drives have that was demanded, over axes and cycles since
  /// it was last taken: above 1 the motion asks for too much.
  virtual double take_saturation() noexcept = 0;
};

}  // namespace rob::motion
