#include "motion/path/joint_spline.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/unit_factors.h"

namespace rob::motion {

namespace {

constexpr double kSame = 1e-9;             // m, rad
constexpr double kMostTurn = 5 * kDegree;  // rad between nodes, as on other paths
constexpr double kLeastPieces = 8;         // [choice] of the way between two points

/// Points of the axes, the parameter in each, 0 … 1, and the second derivatives there.
struct Knots {
  std::vector<double> at;
  std::vector<JointVector> q;
  std::vector<JointVector> bend;
};

/// s: what the slowest axis takes at its full speed.
double least_time(const RobotModel& robot, const JointVector& way) {
  double time = 0;
  for (int i = 0; i < robot.axis_count(); ++i)
    time = std::max(time, std::abs(way[i]) / robot.axes[static_cast<std::size_t>(i)].v_max);
  return time;
}

/// The second derivatives M from  h₋·M₋ + 2(h₋ + h₊)·M + h₊·M₊ = 6·(slope₊ − slope₋), 0 at the
/// ends, eliminated from front to back.
void bend(Knots& knots) {
  const std::size_t n = knots.q.size();
  knots.bend.assign(n, JointVector::Zero(knots.q.front().size()));
  std::vector<double> upper(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = knots.at[i] - knots.at[i - 1];
    const double behind = knots.at[i + 1] - knots.at[i];
    const JointVector turn =
        6 * ((knots.q[i + 1] - knots.q[i]) / behind - (knots.q[i] - knots.q[i - 1]) / before);
    const double pivot = 2 * (before + behind) - before * upper[i - 1];
    upper[i] = behind / pivot;
    knots.bend[i] = (turn - before * knots.bend[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) knots.bend[i] -= upper[i] * knots.bend[i + 1];
}

/// The cubic from knot i to the next one.
JointPath::Node node_at(const Knots& knots, std::size_t i, double s) {
  const double h = knots.at[i + 1] - knots.at[i];
  const double b = (s - knots.at[i]) / h;
  const double a = 1 - b;
  const JointVector& bend = knots.bend[i];
  const JointVector& next = knots.bend[i + 1];
  return {s,
          a * knots.q[i] + b * knots.q[i + 1] +
              ((a * a * a - a) * bend + (b * b * b - b) * next) * (h * h / 6),
          (knots.q[i + 1] - knots.q[i]) / h +
              ((1 - 3 * a * a) * bend + (3 * b * b - 1) * next) * (h / 6),
          a * bend + b * next};
}

/// In so many pieces no rotary axis turns by more than kMostTurn: its rate is at most that of the
/// chord and what the bends at both ends add.
double pieces_of(const RobotModel& robot, const Knots& knots, std::size_t i) {
  const double h = knots.at[i + 1] - knots.at[i];
  double pieces = kLeastPieces;
  for (int k = 0; k < robot.axis_count(); ++k) {
    if (robot.axes[static_cast<std::size_t>(k)].kind == AxisKind::Linear) continue;
    const double bends = std::abs(knots.bend[i][k]) + std::abs(knots.bend[i + 1][k]);
    const double turn = std::abs(knots.q[i + 1][k] - knots.q[i][k]) + bends * h * h / 3;
    pieces = std::max(pieces, std::ceil(turn / kMostTurn));
  }
  return pieces;
}

/// A quintic between nodes that have the values and both derivatives of a cubic is that cubic.
JointPath path_through(const RobotModel& robot, const Knots& knots) {
  std::vector<JointPath::Node> nodes;
  for (std::size_t i = 0; i + 1 < knots.q.size(); ++i) {
    const double pieces = pieces_of(robot, knots, i);
    const double h = knots.at[i + 1] - knots.at[i];
    for (double k = 0; k < pieces; ++k)
      nodes.push_back(node_at(knots, i, knots.at[i] + k * h / pieces));
  }
  nodes.push_back(node_at(knots, knots.q.size() - 2, knots.at.back()));
  nodes.back().q = knots.q.back();
  return JointPath(std::move(nodes));
}

}  // namespace

std::optional<JointSpline> JointSpline::through(const RobotModel& robot, const Pose& tip,
                                                const std::vector<JointVector>& points) {
  Knots knots{{0}, points, {}};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const JointVector way = points[i] - points[i - 1];
    if (way.cwiseAbs().maxCoeff() <= kSame) return std::nullopt;
    knots.at.push_back(knots.at.back() + least_time(robot, way));
  }
  const double whole = knots.at.back();
  for (double& at : knots.at) at /= whole;
  bend(knots);
  JointSpline spline(robot, tip);
  spline.axes_ = path_through(robot, knots);
  spline.first_point_ = knots.at[1];
  spline.last_point_ = knots.at[knots.at.size() - 2];
  spline.measure();
  return spline;
}

/// Beyond the ends the axes go on evenly.
Pose JointSpline::at(double s) const noexcept {
  const PathPoint point = axes_.at(s);
  const JointVector q = point.qd * (s - std::clamp(s, axes_.begin(), axes_.end())) + point.q;
  return composed(robot_->kinematics->forward(q), tip_);
}

void JointSpline::measure() {
  // [choice] as for a ToolSpline
  constexpr std::size_t kMostParts = 16384;
  const std::size_t parts = std::min(32 * (axes_.nodes().size() - 1), kMostParts);
  const double step = 1 / static_cast<double>(parts);
  JointVector turns = JointVector::Zero(robot_->axis_count());
  lengths_ = {0};
  PathPoint before = axes_.at(0);
  Eigen::Vector3d place = at(0).position;
  for (std::size_t i = 1; i <= parts; ++i) {
    const double s = static_cast<double>(i) * step;
    const PathPoint point = axes_.at(s);
    const Eigen::Vector3d next = at(s).position;
    const double way = (next - place).norm();
    lengths_.push_back(lengths_.back() + way);
    greatest_speed_ = std::max(greatest_speed_, way / step);
    for (int k = 0; k < robot_->axis_count(); ++k) {
      if (robot_->axes[static_cast<std::size_t>(k)].kind == AxisKind::Linear) continue;
      const double turned = std::abs(point.q[k] - before.q[k]);
      turns[k] += turned;
      greatest_turning_ = std::max(greatest_turning_, turned / step);
    }
    before = point;
    place = next;
  }
  turn_ = turns.maxCoeff();
}

double JointSpline::share_at(double s) const noexcept {
  const double place = std::clamp(s, 0.0, 1.0) * static_cast<double>(lengths_.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), lengths_.size() - 2);
  const double within = place - static_cast<double>(i);
  if (!(way() > kSame)) return s;
  return (lengths_[i] + within * (lengths_[i + 1] - lengths_[i])) / way();
}

}  // namespace rob::motion
