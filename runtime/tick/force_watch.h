#pragma once

#include "motion/servo/following_supervisor.h"
#include "motion/space/wrench.h"
#include "runtime/tick/force_gauge.h"

namespace rob::runtime {

/// Finds forces beyond the robot's limit, and a sensor that has stopped telling. Every call may be
/// used in the tick.
class ForceWatch {
 public:
  /// `limit`: N; 0: none.
  explicit ForceWatch(double limit) noexcept : limit_(limit) {}

  /// Once a cycle. `felt`: along the world; `braking`: the program brakes by itself. A finding that
  /// stops the robot, or none.
  motion::FollowingFinding judge(const motion::Wrench& felt, bool braking) noexcept;

 private:
  double limit_;
  int beyond_ = 0;         ///< cycles in which the force has been beyond the limit
  bool yielding_ = false;  ///< the program has braked meanwhile
};

/// The same for a sensor on which somebody counts; `now`: s.
motion::FollowingFinding judge_sensor(const ForceGauge& gauge, double now) noexcept;

}  // namespace rob::runtime
