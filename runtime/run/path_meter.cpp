#include "runtime/run/path_meter.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace rob::runtime {

double distance_to_chord(const Eigen::Vector3d& point, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& to) {
  const Eigen::Vector3d chord = to - from;
  const double length2 = chord.squaredNorm();
  const double share = length2 > 0 ? std::clamp(chord.dot(point - from) / length2, 0.0, 1.0) : 0.0;
  return (from + share * chord - point).norm();
}

namespace {

/// Whether the points lie one after the other on one chord, but for rounding.
bool lie_on_chord(const std::vector<Eigen::Vector3d>& points) {
  constexpr double kRounding = 1e-12;  // m
  double passed = 0;
  for (const Eigen::Vector3d& point : points) {
    const double way = (point - points.front()).norm();
    if (way < passed - kRounding) return false;
    if (distance_to_chord(point, points.front(), points.back()) > kRounding) return false;
    passed = way;
  }
  return true;
}

}  // namespace

void PathMeter::programmed(const motion::LegMotion& motion, bool line, const Eigen::Vector3d& tip) {
  if (std::exchange(free_, false)) count_ = 0;
  Leg& leg = legs_[count_++ % kLegs];
  leg.tip = tip;
  leg.points.clear();
  const std::size_t curved = motion.path == nullptr ? kChords : kPathChords;
  const std::size_t chords = line ? 1 : curved;
  for (std::size_t i = 0; i <= chords; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(chords);
    const motion::JointVector q = motion.along(share, 0, 0).q;
    leg.points.push_back(place_of(tip, kinematics_->forward(q)));
  }
  if (lie_on_chord(leg.points)) leg.points = {leg.points.front(), leg.points.back()};
}

void PathMeter::unprogrammed(const Eigen::Vector3d& tip) {
  count_ = 1;
  legs_[0].tip = tip;
  free_ = true;
}

double PathMeter::reference(const motion::JointVector& q) {
  const motion::Pose flange = kinematics_->forward(q);
  const motion::Pose before = std::exchange(last_, flange);
  if (count_ == 0) return 0;
  const Eigen::Vector3d& tip = legs_[(count_ - 1) % kLegs].tip;
  const double way = (place_of(tip, flange) - place_of(tip, before)).norm();
  if (way > 0 && !free_) deviation_ = std::max(deviation_, distance(flange));
  return way;
}

/// Looks no further, from the newest leg back, where it cannot be greater than deviation().
double PathMeter::distance(const motion::Pose& flange) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i <= std::min(count_, kLegs) && least > deviation_; ++i)
    least = std::min(least, legs_[(count_ - i) % kLegs].distance(flange, deviation_));
  return least;
}

/// The distance of the nearest chord, or of one that is no farther than `enough`.
double PathMeter::Leg::distance(const motion::Pose& flange, double enough) const {
  const Eigen::Vector3d point = place_of(tip, flange);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t chord = 0; chord + 1 < points.size() && least > enough; ++chord)
    least = std::min(least, distance_to_chord(point, points[chord], points[chord + 1]));
  return least;
}

}  // namespace rob::runtime
