#include "runtime/tick/touch.h"

#include <algorithm>

#include "runtime/tick/axis_values.h"

namespace rob::runtime {

Touch::Touch(const motion::RobotModel& robot)
    : v_max_(axis_values(robot, &motion::Axis::v_max)),
      brake_(axis_values(robot, &motion::Axis::a_max)) {}

void Touch::lose(double now, double gap) noexcept {
  state_ = State::Lost;
  lost_ = now;
  gap_ = gap;
}

bool Touch::finds(const motion::ServoState& state) const noexcept {
  const motion::JointMeasurement& found = state.measured;
  const bool fresh = std::max(state.seen, found.time) >= lost_;
  return fresh && found.q.allFinite() && found.qd.allFinite();
}

void Touch::brake(motion::JointReference found, const motion::JointVector& velocity) noexcept {
  found.qd = velocity.cwiseMin(v_max_).cwiseMax(-v_max_);
  brake_.start(found);
  state_ = State::Braked;
}

}  // namespace rob::runtime
