#include "runtime/program/path_meter.h"

#include <algorithm>
#include <limits>

namespace rob::runtime {

double distance_to_chord(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& to) {
  const Eigen::Vector3d chord = to - from;
  const double length2 = chord.squaredNorm();
  const double share = length2 > 0 ? std::clamp(chord.dot(point - from) / length2, 0.0, 1.0) : 0.0;
  return (from + share * chord - point).norm();
}

void PathMeter::programmed(const motion::JointVector& from, const motion::JointVector& to) {
  Leg& leg = legs_[count_++ % kLegs];
  for (std::size_t i = 0; i <= kChords; ++i) {
    const double share = static_cast<double>(i) / kChords;
    leg[i] = kinematics_->forward(from + share * (to - from)).position;
  }
}

double PathMeter::reference(const motion::JointVector& q) {
  const Eigen::Vector3d position = kinematics_->forward(q).position;
  const double way = (position - last_).norm();
  last_ = position;
  if (way > 0 && count_ > 0) deviation_ = std::max(deviation_, distance(position));
  return way;
}

double PathMeter::distance(const Eigen::Vector3d& point) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(count_, kLegs); ++i) {
    for (std::size_t chord = 0; chord < kChords; ++chord) {
      least = std::min(least, distance_to_chord(point, legs_[i][chord], legs_[i][chord + 1]));
    }
  }
  return least;
}

}  // namespace rob::runtime
