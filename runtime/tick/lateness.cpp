#include "runtime/tick/lateness.h"

#include <algorithm>
#include <cmath>

#include "motion/servo/reference_interpolator.h"

namespace rob::runtime {

namespace {

constexpr double kPatience = 0.01;  // s [choice] for a thread that the same computer runs next

/// As much lateness as the generator makes up (20 reference periods, at least 200 ms), and the
/// period itself.
double longest_gap_of(const motion::RobotModel& robot) {
  return std::max(20 * robot.reference_period, 0.2) + robot.reference_period;
}

/// The longest gap, and twice the way v²/a_max that the axes lose when they start again from rest
/// with half of their acceleration.
double most_behind_of(const motion::RobotModel& robot) {
  double start = 0;
  for (const motion::Axis& axis : robot.axes) start = std::max(start, axis.v_max / axis.a_max);
  return longest_gap_of(robot) + 2 * start;
}

}  // namespace

Lateness::Lateness(const motion::RobotModel& robot)
    : reference_period_(robot.reference_period),
      bridged_((motion::ReferenceInterpolator::kLongestGap - 1) *
               std::max(robot.reference_period, robot.servo_period)),
      longest_(longest_gap_of(robot)),
      most_behind_(most_behind_of(robot)) {}

/// The whole process was stopped for a while, and this thread came back before the one that makes
/// the references: what it lacks, or the instant from which it holds, is about to come. Until then
/// the drives go on as they were commanded; but not for long, since that thread may be late again.
bool Lateness::references_are_coming(double now, double gap) noexcept {
  const bool missing =
      !bridged(gap) && gap <= longest_ && std::abs(now - newest_) > reference_period_;
  if (!missing) {
    waiting_since_.reset();
    return false;
  }
  if (!waiting_since_) waiting_since_ = now;
  return now - *waiting_since_ <= std::max(reference_period_, kPatience);
}

}  // namespace rob::runtime
