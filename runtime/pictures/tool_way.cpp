#include "runtime/pictures/tool_way.h"

#include <algorithm>

#include "motion/space/quintic.h"

namespace rob::runtime {

namespace {

constexpr int kMostHalvings = 10;          // [choice] 1000 chords a period
constexpr std::size_t kMostBetween = 256;  // [choice] a point of a straight way looks at no more

double distance_to_chord(const Eigen::Vector3d& p, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& to) {
  const Eigen::Vector3d way = to - from;
  const double length = way.squaredNorm();
  const double share = length > 0 ? std::clamp((p - from).dot(way) / length, 0.0, 1.0) : 0.0;
  return (p - from - share * way).norm();
}

}  // namespace

void ToolWay::take(const Snapshot& snapshot) {
  const motion::JointReference& next = snapshot.sample.reference;
  if (!last_) {
    place_ = place_at(next.q);
  } else if (next.q != last_->q) {
    const int line = static_cast<int>(snapshot.sample.tag);
    if (stretches_.empty() || stretches_.back().line != line || between_.empty()) begin(line);
    const Place end = place_at(next.q);
    divide(next, last_->time, place_, next.time, end, 0);
    place_ = end;
  } else {
    between_.clear();  // it stands: what comes is a new stretch
  }
  last_ = next;
}

void ToolWay::begin(int line) {
  stretches_.push_back({line, last_->time, last_->time, {place_}});
  between_.assign(1, place_);
}

/// Adds chords from one instant to another until each is close enough to the way.
void ToolWay::divide(const motion::JointReference& next, double from, const Place& start, double to,
                     const Place& end, int depth) {
  const double middle = (from + to) / 2;
  const Place on_way = place_at(motion::quintic_between(*last_, next, middle).q);
  constexpr double kShare = 0.25;  // of a chord; the rest is for those that are joined
  const bool close = distance_to_chord(on_way, start, end) <= kShare * kMiss;
  if ((close && depth > 0) || depth == kMostHalvings) {
    add(middle, on_way);
    return add(to, end);
  }
  divide(next, from, start, middle, on_way, depth + 1);
  divide(next, middle, on_way, to, end, depth + 1);
}

/// The last point moves on as long as the chord to it passes all points that came before.
void ToolWay::add(double time, const Place& place) {
  Stretch& stretch = stretches_.back();
  stretch.ends = time;
  const bool first = between_.size() == 1;
  if (first || !lies_on_chord(place)) {
    if (!first) between_.assign(1, between_.back());
    stretch.corners.push_back(place);
  } else {
    stretch.corners.back() = place;
  }
  between_.push_back(place);
}

bool ToolWay::lies_on_chord(const Place& end) const {
  constexpr double kShare = 0.75;
  return between_.size() < kMostBetween && std::ranges::all_of(between_, [&](const Place& p) {
           return distance_to_chord(p, between_.front(), end) <= kShare * kMiss;
         });
}

Eigen::Vector3d ToolWay::at(double time) const {
  if (stretches_.empty()) return last_ ? place_ : place_at(robot_.start);
  const auto next = std::ranges::find_if(
      stretches_, [&](const Stretch& stretch) { return stretch.ends >= time; });
  if (next == stretches_.end()) return stretches_.back().corners.back();
  const bool nearer_to_end = time - next->begins > next->ends - time;
  return nearer_to_end ? next->corners.back() : next->corners.front();
}

}  // namespace rob::runtime
