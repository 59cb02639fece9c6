#include "runtime/program/corner_meter.h"

#include <algorithm>
#include <limits>

namespace rob::runtime {

namespace {

double distance_to_chord(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& to) {
  const Eigen::Vector3d chord = to - from;
  const double length2 = chord.squaredNorm();
  const double share = length2 > 0 ? std::clamp(chord.dot(point - from) / length2, 0.0, 1.0) : 0.0;
  return (from + share * chord - point).norm();
}

}  // namespace

void CornerMeter::watch(std::uint32_t number, const motion::JointVector& target) {
  auto free = std::find_if(vertices_.begin(), vertices_.end(),
                           [](const Vertex& v) { return v.number == 0; });
  if (free == vertices_.end()) {
    free = std::min_element(vertices_.begin(), vertices_.end(),
                            [](const Vertex& a, const Vertex& b) { return a.number < b.number; });
  }
  *free = {number, kinematics_.forward(target).position, std::numeric_limits<double>::infinity()};
}

void CornerMeter::measured(const motion::JointVector& q) {
  const Eigen::Vector3d position = kinematics_.forward(q).position;
  for (Vertex& vertex : vertices_) {
    if (vertex.number == 0) continue;
    vertex.least = std::min(vertex.least,
                            distance_to_chord(vertex.position, last_.value_or(position), position));
  }
  last_ = position;
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
