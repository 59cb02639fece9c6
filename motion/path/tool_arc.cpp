#include "motion/path/tool_arc.h"

#include <cmath>

#include "base/unit_factors.h"
#include "motion/space/rotation.h"

namespace rob::motion {

std::optional<ToolArc> ToolArc::through(const Pose& from, const Eigen::Vector3d& via,
                                        const Pose& to) {
  constexpr double kOnLine = 1e-9;
  const Eigen::Vector3d a = via - from.position;
  const Eigen::Vector3d b = to.position - from.position;
  const Eigen::Vector3d normal = a.cross(b);
  ToolArc arc;
  arc.rotation_ = rotation_between(from.orientation, to.orientation);
  if (!(normal.norm() > kOnLine * a.norm() * b.norm()) || (b - a).norm() <= kOnLine * b.norm() ||
      arc.rotation_.norm() > kLongestTurn) {
    return std::nullopt;
  }
  // The centre of the circle through three points.
  const Eigen::Vector3d to_centre =
      (b.squaredNorm() * normal.cross(a) + a.squaredNorm() * b.cross(normal)) /
      (2 * normal.squaredNorm());
  arc.from_ = from;
  arc.centre_ = from.position + to_centre;
  arc.out_ = -to_centre;
  arc.ahead_ = normal.normalized().cross(arc.out_);
  const Eigen::Vector3d end = to.position - arc.centre_;
  arc.angle_ = std::atan2(end.dot(arc.ahead_), end.dot(arc.out_));
  if (arc.angle_ <= 0) arc.angle_ += kFullTurn;
  return arc;
}

Pose ToolArc::at(double s) const noexcept {
  const double angle = s * angle_;
  return {centre_ + std::cos(angle) * out_ + std::sin(angle) * ahead_,
          rotation_by(s * rotation_) * from_.orientation};
}

}  // namespace rob::motion
