#include "motion/generate/position_error.h"

#include <cmath>

#include "motion/space/pose.h"

namespace rob::motion {

PositionError position_error(const RobotModel& robot, const SettleWindow& window,
                             const JointVector& measured, const JointVector& reference) noexcept {
  using Kind = PositionError::Kind;
  const Pose is = robot.kinematics->forward(measured);
  const Pose should = robot.kinematics->forward(reference);
  const double away = (place_of(window.tip, is) - place_of(window.tip, should)).norm();
  if (!(away <= window.distance)) return {Kind::Place, -1, away, window.distance};
  const double turned = is.orientation.angularDistance(should.orientation);
  if (!(turned <= window.angle)) return {Kind::Turn, -1, turned, window.angle};
  for (int i = 0; i < robot.axis_count(); ++i) {
    const double off = std::abs(measured[i] - reference[i]);
    const bool rotary = robot.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary;
    if (rotary && !(off <= window.angle)) return {Kind::Axis, i, off, window.angle};
  }
  return {};
}

}  // namespace rob::motion
