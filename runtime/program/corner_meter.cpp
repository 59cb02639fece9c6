#include "runtime/program/corner_meter.h"

#include <algorithm>
#include <limits>

#include "runtime/program/path_meter.h"

namespace rob::runtime {

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
