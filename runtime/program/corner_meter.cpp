#include "runtime/program/corner_meter.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "runtime/program/path_meter.h"

namespace rob::runtime {

void CornerMeter::watch(std::uint32_t number, const motion::JointVector& target,
                        const Eigen::Vector3d& tip) {
  auto free = std::find_if(vertices_.begin(), vertices_.end(),
                           [](const Vertex& v) { return v.number == 0; });
  if (free == vertices_.end()) {
    free = std::min_element(vertices_.begin(), vertices_.end(),
                            [](const Vertex& a, const Vertex& b) { return a.number < b.number; });
  }
  *free = {number, tip, place_of(tip, kinematics_.forward(target)), Eigen::Vector3d::Zero(),
           std::numeric_limits<double>::infinity()};
  if (last_) free->passed = place_of(tip, *last_);
}

void CornerMeter::measured(const motion::JointVector& q, const Eigen::Vector3d& pressed) {
  motion::Pose flange = kinematics_.forward(q);
  flange.position -= pressed;
  for (Vertex& vertex : vertices_) {
    if (vertex.number == 0) continue;
    const Eigen::Vector3d place = place_of(vertex.tip, flange);
    if (!last_) vertex.passed = place;
    vertex.pass(place);
  }
  last_ = flange;
}

/// No chord of length c is nearer than d − c, where its end is at d.
void CornerMeter::Vertex::pass(const Eigen::Vector3d& place) {
  constexpr double kSquares = 2.001;  // (least + c)² is at most twice the squares; and rounding
  const Eigen::Vector3d before = std::exchange(passed, place);
  const double reach = kSquares * (least * least + (place - before).squaredNorm());
  if ((position - place).squaredNorm() > reach) return;
  least = std::min(least, distance_to_chord(position, before, place));
}

std::optional<double> CornerMeter::take(std::uint32_t number) {
  for (Vertex& vertex : vertices_) {
    if (vertex.number != number) continue;
    vertex.number = 0;
    if (vertex.least < std::numeric_limits<double>::infinity()) return vertex.least;
  }
  return std::nullopt;
}

}  // namespace rob::runtime
