#include "runtime/run/stepper.h"

#include "motion/space/cycle_instant.h"

namespace rob::runtime {

Stepper::Stepper(Controller& controller) : controller_(controller) {
  controller.servo().enable(clock_.now());
  controller.motion().prepare(clock_.now());
}

void Stepper::cycle() {
  servo_cycles();
  controller_.watch_jogs();
  controller_.motion().cycle(next_++, 0);
}

/// Neither period need be a multiple of the other.
void Stepper::servo_cycles() {
  const motion::RobotModel& robot = controller_.robot();
  const double until = motion::cycle_instant(next_, robot.reference_period);
  for (;; ++next_servo_) {
    const double instant = motion::cycle_instant(next_servo_, robot.servo_period);
    if (instant > until + motion::kSameInstant) break;
    clock_.sleep_until(instant);
    controller_.servo().cycle(clock_.now());
  }
  clock_.sleep_until(until);
}

}  // namespace rob::runtime
