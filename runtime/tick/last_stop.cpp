#include "runtime/tick/last_stop.h"

#include "runtime/tick/axis_values.h"

namespace rob::runtime {

namespace {

constexpr double kLongestSearch = 1;  // s [choice] for a machine that does not say where it is

}  // namespace

LastStop::LastStop(const motion::RobotModel& robot)
    : period_(robot.reference_period), brake_(axis_values(robot, &motion::Axis::a_max)) {
  last_.q = robot.start;
  last_.qd = last_.qdd = motion::JointVector::Zero(robot.axis_count());
}

void LastStop::brake(const motion::JointReference& from) noexcept {
  lost_.reset();
  brake_.start(from);
}

void LastStop::lose_touch(double now) noexcept {
  if (!active()) lost_ = now;
}

void LastStop::take(const ServoSample& sample) noexcept {
  const bool searching =
      sample.finding.cause == motion::FollowingFinding::Cause::Overrun && !sample.braked;
  if (lost_ && !searching && sample.time >= *lost_ - period_) brake(sample.reference);
}

bool LastStop::lead(motion::GeneratorSample& sample, double stamp) noexcept {
  using motion::MotionState;
  if (lost_) {
    last_.qd.setZero();
    last_.qdd.setZero();
    sample.reference = last_;
    sample.reference.time = stamp;
    sample.state = MotionState::Stopping;
    if (stamp - *lost_ > kLongestSearch) brake(sample.reference);
  }
  if (brake_.active()) {
    sample.reference = brake_.at(stamp);
    sample.rate = 0;
    sample.state = stamp < brake_.rest() ? MotionState::Stopping : MotionState::Held;
  }
  last_ = sample.reference;
  return brake_.active() && brake_.take_rest(stamp);
}

}  // namespace rob::runtime
