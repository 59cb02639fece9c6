#include "motion/plan/corner.h"

#include <algorithm>
#include <array>
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
  constexpr int kLooks = 16;
  constexpr double kJerk = 1.05;  // [choice] what a mean over a look leaves of rounding
  double before = 0;
  JointVector qdd;
  corner.axes.survey(kLooks, [&](double t, const PathPoint& point) {
    for (int i = 0; i < robot.axis_count(); ++i) {
      const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
      const double speed = std::abs(point.qd[i]);
      const double acceleration = std::abs(point.qdd[i]) + speed * braking;
      const bool placed = point.q[i] >= axis.min - kRounding && point.q[i] <= axis.max + kRounding;
      if (acceleration > axis.a_max * (1 + kRounding)) finding = Finding::TooHard;
      if (qdd.size() > 0 && std::abs(point.qdd[i] - qdd[i]) > kJerk * axis.j_max * (t - before))
        finding = Finding::TooHard;
      if (finding != Finding::TooHard && (!placed || speed > axis.v_max * (1 + kRounding)))
        finding = Finding::Beyond;
    }
    before = t;
    qdd = point.qdd;
  });
  return finding;
}

constexpr int kChords = 64;  // [choice] of a whole turn: 0.12 % of its radius off
using Polyline = std::array<Eigen::Vector3d, kChords + 1>;

Eigen::Vector3d tip_of(const RobotModel& robot, const CornerTask& task, const JointVector& q) {
  return place_of(task.tip.position, robot.kinematics->forward(q));
}

/// Where the tip would be without the corner; the point is in the middle.
Polyline ways_of(const RobotModel& robot, const CornerTask& task, double half) {
  Polyline ways;
  for (int k = 0; k <= kChords; ++k) {
    const double t = half * (2.0 * k / kChords - 1);
    ways[static_cast<std::size_t>(k)] =
        tip_of(robot, task, t > 0 ? task.out.at(t).q : task.in.at(task.in.duration + t).q);
  }
  return ways;
}

/// The greatest distance of a point of one from the other.
double greatest_distance(const Polyline& points, const Polyline& line) {
  double most = 0;
  for (const Eigen::Vector3d& p : points) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Eigen::Vector3d chord = line[i + 1] - line[i];
      const double square = chord.squaredNorm();
      const double share = square > 0 ? (p - line[i]).dot(chord) / square : 0;
      const Eigen::Vector3d nearest = line[i] + std::clamp(share, 0.0, 1.0) * chord;
      least = std::min(least, (p - nearest).squaredNorm());
    }
    most = std::max(most, least);
  }
  return std::sqrt(most);
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
  const Eigen::Vector3d point = tip_of(robot, task, task.out.from);
  double least = std::numeric_limits<double>::infinity();
  constexpr int kPlaces = 16;
  for (int i = 0; i <= kPlaces; ++i) {
    const double t = axes.end() * (2.0 * i / kPlaces - 1);
    least = std::min(least, (tip_of(robot, task, axes.at(t).q) - point).norm());
  }
  return least;
}

double beside_ways(const RobotModel& robot, const CornerTask& task, const JointPath& axes) {
  const double half = axes.end();
  const Polyline ways = ways_of(robot, task, half);
  Polyline corner;
  for (int k = 0; k <= kChords; ++k)
    corner[static_cast<std::size_t>(k)] =
        tip_of(robot, task, axes.at(half * (2.0 * k / kChords - 1)).q);
  return std::max(greatest_distance(corner, ways), greatest_distance(ways, corner));
}

bool winds_round(const RobotModel& robot, const CornerTask& task, double half) {
  const Polyline ways = ways_of(robot, task, half);
  constexpr std::size_t kPoint = kChords / 2;
  constexpr double kStands = 1e-18;  // m²: the tip goes by less than it can be measured
  const Eigen::Vector3d in = ways[kPoint] - ways[kPoint - 1];
  const Eigen::Vector3d out = ways[kPoint + 1] - ways[kPoint];
  for (std::size_t k = 0; k < kChords; ++k)
    if ((ways[k + 1] - ways[k]).dot(k < kPoint ? in : out) < -kStands) return true;
  return false;
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
