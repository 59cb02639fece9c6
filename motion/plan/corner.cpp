#include "motion/plan/corner.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "motion/path/follow.h"
#include "motion/path/paul_transition.h"
#include "motion/space/rotation.h"

namespace rob::motion {

namespace {

/// Paul's quartic on place and rotation vector around a point between two lines.
class ToolCorner final : public ToolPath {
 public:
  ToolCorner(const Pose& point, const Eigen::Vector3d& v_in, const Eigen::Vector3d& w_in,
             const Eigen::Vector3d& v_out, const Eigen::Vector3d& w_out, double half)
      : point_(point), half_(half) {
    JointVector a(6);
    JointVector c(6);
    a << -half * v_in, -half * w_in;
    c << half * v_out, half * w_out;
    law_ = PaulTransition(a, JointVector::Zero(6), c, half, half);
    way_ = half * (v_in.norm() + v_out.norm());
    turn_ = half * (w_in.norm() + w_out.norm());
  }

  Pose at(double t) const noexcept override {
    const JointVector off = law_.sample(t).q;
    return {point_.position + off.head<3>(), rotation_by(off.tail<3>()) * point_.orientation};
  }
  double begin() const noexcept override { return -half_; }
  double end() const noexcept override { return half_; }
  double way() const noexcept override { return way_; }  // of the legs it replaces
  double turn() const noexcept override { return turn_; }

 private:
  Pose point_;
  double half_;
  PaulTransition law_;
  double way_;
  double turn_;
};

JointPath::Node node(double t, const PathPoint& point) { return {t, point.q, point.qd, point.qdd}; }

enum class Finding { Good, Beyond, TooHard };

/// [choice] of speed, acceleration and place: far below what any drive resolves.
constexpr double kRounding = 1e-9;

Finding judge(const RobotModel& robot, const Corner& corner, double braking) {
  Finding finding = Finding::Good;
  constexpr int kParts = 16;
  corner.axes.survey(kParts, [&](double /*t*/, const PathPoint& point) {
    for (int i = 0; i < robot.axis_count(); ++i) {
      const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
      const double speed = std::abs(point.qd[i]);
      const double acceleration = std::abs(point.qdd[i]) + speed * braking;
      const bool placed = point.q[i] >= axis.min - kRounding && point.q[i] <= axis.max + kRounding;
      if (acceleration > axis.a_max * (1 + kRounding)) finding = Finding::TooHard;
      if (finding != Finding::TooHard && (!placed || speed > axis.v_max * (1 + kRounding)))
        finding = Finding::Beyond;
    }
  });
  return finding;
}

}  // namespace

std::optional<JointPath> corner_axes(const RobotModel& robot, const CornerTask& task, double half) {
  const PathPoint first = task.in.at(task.in.duration - half);
  const PathPoint last = task.out.at(half);
  if (task.line_in == nullptr || task.line_out == nullptr) {
    return JointPath({node(-half, first), node(half, last)});
  }
  const ToolLine& in = *task.line_in;
  const ToolLine& out = *task.line_out;
  const ToolCorner corner(out.at(0), in.shift() / task.in.duration,
                          in.rotation() / task.in.duration, out.shift() / task.out.duration,
                          out.rotation() / task.out.duration, half);
  Followed followed = follow(robot, corner, task.tip, first.q, &first, &last);
  if (followed.trouble) return std::nullopt;
  return std::move(followed.axes);
}

double corner_miss_of(const RobotModel& robot, const CornerTask& task, const JointPath& axes) {
  const auto place = [&](const JointVector& q) {
    return place_of(task.tip.position, robot.kinematics->forward(q));
  };
  const Eigen::Vector3d point = place(task.out.from);
  double least = std::numeric_limits<double>::infinity();
  constexpr int kPlaces = 16;
  for (int i = 0; i <= kPlaces; ++i) {
    const double t = axes.end() * (2.0 * i / kPlaces - 1);
    least = std::min(least, (place(axes.at(t).q) - point).norm());
  }
  return least;
}

std::optional<Corner> make_corner(const RobotModel& robot, const CornerTask& task) {
  constexpr int kTries = 12;
  constexpr double kShrink = 0.8;
  constexpr double kNearly = 0.9999;
  Corner corner;
  corner.half = task.longest;
  for (int i = 0; i < kTries; ++i) {
    double shrink = kShrink;
    if (auto axes = corner_axes(robot, task, corner.half)) {
      corner.axes = std::move(*axes);
      const double miss = corner_miss_of(robot, task, corner.axes);
      const Finding finding = judge(robot, corner, task.braking);
      if (finding == Finding::TooHard) return std::nullopt;  // shorter would be harder still
      if (finding == Finding::Good && miss <= task.zone) return corner;
      // The miss goes with the corner's time where the legs are straight.
      if (miss > task.zone) shrink = kNearly * task.zone / miss;
    }
    corner.half *= shrink;
  }
  return std::nullopt;
}

}  // namespace rob::motion
