#include "runtime/run/corner_meter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "runtime/run/path_meter.h"

namespace rob::runtime {

void CornerMeter::forget_oldest() {
  const auto open = [](const Vertex& vertex) { return vertex.left == kUnbounded; };
  if (std::ranges::count_if(vertices_, open) < kNear) return;
  vertices_.erase(std::ranges::find_if(vertices_, open));
}

/// The last poses count only if the point lies within their way. Otherwise the tip may have left
/// this place long ago, and is to come back to it.
void CornerMeter::watch(std::uint32_t number, const motion::JointVector& target,
                        const Eigen::Vector3d& tip) {
  forget_oldest();
  Vertex vertex{number, tip, place_of(tip, kinematics_.forward(target))};
  vertex.least = std::numeric_limits<double>::infinity();
  if (!poses_.empty()) {
    const Eigen::Vector3d here = place_of(tip, poses_.back());
    const double way = (here - place_of(tip, poses_.front())).norm();
    vertex.passed = here;
    if ((vertex.position - here).norm() < way) {
      vertex.passed = place_of(tip, poses_.front());
      for (const motion::Pose& pose : poses_) vertex.pass(place_of(tip, pose));
    }
  }
  vertices_.push_back(vertex);
}

void CornerMeter::measured(const motion::JointVector& q, const Eigen::Vector3d& pressed) {
  motion::Pose flange = kinematics_.forward(q);
  flange.position -= pressed;
  for (Vertex& vertex : vertices_) {
    if (vertex.left == 0) continue;
    const Eigen::Vector3d place = place_of(vertex.tip, flange);
    if (poses_.empty()) vertex.passed = place;
    vertex.pass(place);
    if (vertex.left > 0) --vertex.left;
  }
  poses_.push_back(flange);
  if (poses_.size() > kAround + 1) poses_.pop_front();
}

/// No chord of length c is nearer than d − c, where its end is at d.
void CornerMeter::Vertex::pass(const Eigen::Vector3d& place) {
  constexpr double kSquares = 2.001;  // (least + c)² is at most twice the squares; and rounding
  const Eigen::Vector3d before = std::exchange(passed, place);
  const double reach = kSquares * (least * least + (place - before).squaredNorm());
  if ((position - place).squaredNorm() > reach) return;
  least = std::min(least, distance_to_chord(position, before, place));
}

void CornerMeter::leave(std::uint32_t number, std::uint32_t tag) {
  for (Vertex& vertex : vertices_) {
    if (vertex.number != number || vertex.left != kUnbounded) continue;
    vertex.tag = tag;
    vertex.left = kAround;
  }
}

std::optional<CornerMeter::Miss> CornerMeter::take(bool all) {
  const auto known = [&](const Vertex& vertex) {
    return vertex.left == 0 || (all && vertex.left > 0);
  };
  const auto found = std::ranges::find_if(vertices_, known);
  if (found == vertices_.end()) return std::nullopt;
  const Miss miss{found->tag, found->least};
  vertices_.erase(found);
  return std::isfinite(miss.least) ? std::optional(miss) : take(all);
}

}  // namespace rob::runtime
