#include "motion/path/follow.h"

#include <algorithm>
#include <cmath>

#include "base/unit_factors.h"
#include "motion/space/quintic.h"
#include "motion/space/rotation.h"

namespace rob::motion {

namespace {

/// How far from node to node, and how near the nodes may come.
struct Steps {
  double turn;   ///< rad
  double least;  ///< m of the path
};
constexpr Steps kClosed{5 * kDegree, 1e-5};
/// Where the axes are found by iteration.
constexpr Steps kIterated{0.05, 1e-6};
constexpr double kAgreed = 1e-6;    // rad: one branch, found from either side
constexpr double kOffPlace = 5e-7;  // m
constexpr double kOffTurn = 1e-5;   // rad

/// The share of a step between the places from which a derivative is made. [choice] the error of
/// the differences, of sixth order, is then far below that of the quintic between the nodes.
constexpr double kSpacing = 1.0 / 16;

class Follower {
 public:
  using Node = JointPath::Node;

  Follower(const RobotModel& robot, const ToolPath& path, const Pose& tip, const ValueSpline* spare)
      : robot_(robot),
        path_(path),
        tip_(tip),
        spare_(spare),
        flange_(inverse(tip)),
        steps_(robot.kinematics->iterates() ? kIterated : kClosed),
        length_(path.end() - path.begin()),
        longest_step_(length_ / path.parts()),
        least_step_(std::min(least_share(path, steps_) * length_, longest_step_)) {}

  Followed run(const JointVector& start, const PathPoint* first, const PathPoint* last) {
    Node node{path_.begin(), start, {}, {}};
    if (!(path_.parts() <= kMostNodes)) return {{}, too_long(node)};
    if (!begin(node, first)) return {{}, PathTrouble{trouble_, node.time, axis_}};
    std::vector<Node> nodes{node};
    double step = longest_step_;
    while (node.time < path_.end()) {
      Node next;
      while (!advance(node, step, last, next)) {
        if (step < least_step_) {
          return {nodes.size() > 1 ? JointPath(std::move(nodes)) : JointPath(),
                  PathTrouble{trouble_, node.time, axis_}};
        }
        step /= 2;
      }
      nodes.push_back(next);
      node = next;
      step = std::min(2 * step, longest_step_);
      if (nodes.size() > kMostNodes) return {JointPath(std::move(nodes)), too_long(node)};
    }
    return {JointPath(std::move(nodes)), std::nullopt};
  }

 private:
  /// Where the tool itself turns on a short way, a quarter of what an axis may with it.
  static double least_share(const ToolPath& path, const Steps& steps) {
    return std::min(steps.least / measure_of(path), steps.turn / 4 / path.turn());
  }

  static PathTrouble too_long(const Node& node) {
    return {PathTrouble::Kind::TooLong, node.time, -1};
  }

  static void set(Node& node, const PathPoint& point) {
    node.q = point.q;
    node.qd = point.qd;
    node.qdd = point.qdd;
  }

  bool begin(Node& node, const PathPoint* first) {
    if (first != nullptr) {
      set(node, *first);
      return true;
    }
    for (double step = longest_step_; step >= least_step_ / 2; step /= 2) {
      if (derive(node, step * kSpacing)) return true;
    }
    return false;
  }

  /// The next node, about `step` farther; false where that is too far.
  bool advance(const Node& from, double step, const PathPoint* last, Node& next) {
    const double left = path_.end() - from.time;
    const bool ends = left < 1.5 * step;
    const double d = ends ? left : step;
    next.time = ends ? path_.end() : from.time + step;
    const JointVector ahead = from.q + from.qd * d + from.qdd * (d * d / 2);
    const auto q = solve(next.time, ahead);
    if (!q) return false;
    next.q = *q;
    if (!near(from.q, next.q) || !same_branch(from, next)) return false;
    if (ends && last != nullptr) {
      set(next, *last);
    } else if (!derive(next, d * kSpacing)) {
      return false;
    }
    return keeps_path(from, next);
  }

  std::optional<JointVector> solve(double s, const JointVector& near_to) {
    const Pose flange = composed(path_.at(s), flange_);
    auto q = spare_ != nullptr ? with_spare(flange, s, near_to)
                               : robot_.kinematics->inverse(flange, near_to);
    if (!q) trouble_ = PathTrouble::Kind::OutOfReach;
    return q;
  }

  std::optional<JointVector> with_spare(const Pose& flange, double s, JointVector near_to) const {
    near_to[robot_.kinematics->spare()] = spare_->at(s);
    return robot_.kinematics->beside(flange, near_to);
  }

  /// No rotary axis turns by more than it may between nodes.
  bool near(const JointVector& a, const JointVector& b) {
    double most = 0;
    for (int i = 0; i < robot_.axis_count(); ++i) {
      const double turn = std::abs(b[i] - a[i]);
      if (robot_.axes[static_cast<std::size_t>(i)].kind == AxisKind::Linear || turn <= most)
        continue;
      most = turn;
      most_turned_ = i;
    }
    if (most <= steps_.turn) return true;
    jumps();
    return false;
  }

  /// The place half-way, found from both ends.
  bool same_branch(const Node& a, const Node& b) {
    if (!robot_.kinematics->iterates()) return true;
    const double middle = (a.time + b.time) / 2;
    const auto from_a = solve(middle, a.q);
    const auto from_b = solve(middle, b.q);
    if (!from_a || !from_b) return false;
    if ((*from_a - *from_b).cwiseAbs().maxCoeff() <= kAgreed) return true;
    jumps();
    return false;
  }

  void jumps() {
    trouble_ = PathTrouble::Kind::Singular;
    axis_ = most_turned_;
  }

  /// Central differences of sixth order (Fornberg 1988, table 1).
  bool derive(Node& node, double h) {
    JointVector odd = JointVector::Zero(node.q.size());
    JointVector even = -490 * node.q;
    constexpr std::array<double, 3> kOdd{45, -9, 1};
    constexpr std::array<double, 3> kEven{270, -27, 2};
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = static_cast<double>(k + 1) * h;
      const auto before = solve(node.time - d, node.q);
      const auto behind = solve(node.time + d, node.q);
      if (!before || !behind || !near(node.q, *before) || !near(node.q, *behind)) return false;
      odd += kOdd[k] * (*behind - *before);
      even += kEven[k] * (*behind + *before);
    }
    node.qd = odd / (60 * h);
    node.qdd = even / (180 * h * h);
    return true;
  }

  bool keeps_path(const Node& a, const Node& b) {
    for (const double share : {0.25, 0.5, 0.75}) {
      const double s = a.time + share * (b.time - a.time);
      const Pose flange = robot_.kinematics->forward(quintic_between(a, b, s).q);
      const Pose wanted = path_.at(s);
      const Eigen::Quaterniond turned = flange.orientation * tip_.orientation;
      const bool close = (place_of(tip_.position, flange) - wanted.position).norm() <= kOffPlace &&
                         off_turn(turned, wanted.orientation) <= kOffTurn;
      if (close) continue;
      jumps();
      return false;
    }
    return true;
  }

  /// rad, but for what the axes leave to the place.
  double off_turn(const Eigen::Quaterniond& is, const Eigen::Quaterniond& wanted) const {
    const Eigen::Quaterniond turn = wanted * is.conjugate();
    return rotation_vector(without_free(turn, robot_.kinematics->freedom(), is)).norm();
  }

  const RobotModel& robot_;
  const ToolPath& path_;
  const Pose& tip_;
  const ValueSpline* spare_;  ///< null: the spare axis stands, if there is one
  const Pose flange_;         ///< seen from the tip
  const Steps steps_;
  const double length_;
  const double longest_step_;
  const double least_step_;
  PathTrouble::Kind trouble_ = PathTrouble::Kind::OutOfReach;
  int axis_ = -1;
  int most_turned_ = 0;
};

}  // namespace

Followed follow(const RobotModel& robot, const ToolPath& path, const Pose& tip,
                const JointVector& start, const PathPoint* first, const PathPoint* last,
                const ValueSpline* spare) {
  return Follower(robot, path, tip, spare).run(start, first, last);
}

}  // namespace rob::motion
