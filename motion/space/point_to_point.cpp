#include "motion/space/point_to_point.h"

#include <algorithm>

namespace rob::motion {

PointToPoint::PointToPoint(const JointVector& v_max, const JointVector& a_max,
                           const JointVector& j_max)
    : v_max_(v_max), a_max_(a_max), j_max_(j_max) {}

void PointToPoint::aim(const JointReference& from, const JointVector& target) noexcept {
  begin_ = from.time;
  duration_ = 0;
  for (int i = 0; i < v_max_.size(); ++i) {
    AxisMotion& axis = axes_[static_cast<std::size_t>(i)];
    axis = AxisMotion({from.q[i], from.qd[i], from.qdd[i]}, target[i],
                      {v_max_[i], a_max_[i], j_max_[i]});
    duration_ = std::max(duration_, axis.duration());
  }
  for (int i = 0; i < v_max_.size(); ++i) axes_[static_cast<std::size_t>(i)].stretch(duration_);
}

JointReference PointToPoint::at(double time) const noexcept {
  const double passed = time < arrival() ? time - begin_ : duration_;
  const JointVector none = JointVector::Zero(v_max_.size());
  JointReference reference{time, none, none, none};
  for (int i = 0; i < none.size(); ++i) {
    const AxisState state = axes_[static_cast<std::size_t>(i)].at(passed);
    reference.q[i] = state.q;
    reference.qd[i] = state.v;
    reference.qdd[i] = state.a;
  }
  return reference;
}

}  // namespace rob::motion
