#include "motion/ahead/curve_axes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/path/follow.h"

namespace rob::motion {

namespace {

/// Where the tool of an arm goes along a curve between two u, without turning.
class ToolCurve final : public ToolPath {
 public:
  ToolCurve(const CurveFit& fit, double begin, double end, const Eigen::Quaterniond& orientation)
      : fit_(fit), begin_(begin), end_(end), orientation_(orientation) {}

  /// Beyond its ends the polynomial there goes on.
  Pose at(double s) const noexcept override {
    const double u = begin_ + s * (end_ - begin_);
    const double span = std::clamp(std::floor(u), std::floor(begin_), std::ceil(end_) - 1);
    return {fit_.on_span(u, static_cast<std::size_t>(span)).place, orientation_};
  }
  double way() const noexcept override { return (end_ - begin_) * fit_.knot(); }
  double turn() const noexcept override { return 0; }
  /// [choice] four for each knot
  double parts() const noexcept override { return std::max(1.0, std::ceil(4 * (end_ - begin_))); }

 private:
  const CurveFit& fit_;
  double begin_;
  double end_;
  Eigen::Quaterniond orientation_;
};

/// Between the targets the path is as near to the curve as short motions of the axes are to those
/// of the tool.
JointPath through_targets(const PathPoint& first, const CurvePart& part, double knot,
                          const PathStretch& stretch) {
  const JointVector still = JointVector::Zero(first.q.size());
  const double length = (part.end - part.begin) * knot;
  std::vector<JointPath::Node> nodes{{0, first.q, still, still}};
  for (const PathStretch::Member& member : stretch.members) {
    const bool last = &member == &stretch.members.back();
    const double at = last ? 1 : member.end / length;
    if (at > nodes.back().time) nodes.push_back({at, member.segment.target, still, still});
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const JointPath::Node& before = nodes[i > 0 ? i - 1 : 0];
    const JointPath::Node& after = nodes[std::min(i + 1, nodes.size() - 1)];
    nodes[i].qd = (after.q - before.q) / (after.time - before.time);
  }
  if (first.qd.size() > 0) nodes.front() = {0, first.q, first.qd, first.qdd};
  return JointPath(std::move(nodes));
}

}  // namespace

JointPath follow_curve(const RobotModel& robot, const CurveFit& fit, const CurvePart& part,
                       const PathStretch& stretch, const LegBounds& like, const PathPoint& first) {
  const ToolCurve curve(fit, part.begin, part.end, like.line->at(1).orientation);
  Followed made = follow(robot, curve, like.tip, first.q, first.qd.size() > 0 ? &first : nullptr);
  if (made.trouble) return through_targets(first, part, fit.knot(), stretch);
  return std::move(made.axes);
}

JointPath ending_at(const JointPath& axes, const JointVector& q) {
  std::vector<JointPath::Node> nodes = axes.nodes();
  nodes.back().q = q;
  return JointPath(std::move(nodes));
}

void note_slopes(const CurveFit& fit, const CurvePart& part, PathStretch& stretch) {
  constexpr double kInKnot = 8;  // [choice] a knot bends by a fraction of a right angle
  const double length = part.end - part.begin;
  const double parts = std::ceil(length * kInKnot);
  stretch.slopes_apart = length / parts * fit.knot();
  for (double k = 0; k <= parts; ++k) {
    const double u = std::min(part.begin + length * (k / parts), part.end);
    stretch.slopes.push_back(fit.at(u).first.norm() / fit.knot());
  }
}

}  // namespace rob::motion
