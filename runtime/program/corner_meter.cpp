#include "runtime/program/corner_meter.h"

#include <algorithm>
#include <limits>

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
  *free = {number, tip, place_of(tip, kinematics_.forward(target)),
           std::numeric_limits<double>::infinity()};
}

void CornerMeter::measured(const motion::JointVector& q, const Eigen::Vector3d& pressed) {
  motion::Pose flange = kinematics_.forward(q);
  flange.position -= pressed;
  const motion::Pose before = last_.value_or(flange);
  for (Vertex& vertex : vertices_) {
    if (vertex.number == 0) continue;
    vertex.least =
        std::min(vertex.least, distance_to_chord(vertex.position, place_of(vertex.tip, before),
                                                 place_of(vertex.tip, flange)));
  }
  last_ = flange;
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
