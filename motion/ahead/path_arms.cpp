// The PathPlanner on an arm: it decides whether a corner pays, and with which mean.

#include <algorithm>
#include <utility>

#include "motion/ahead/path_planner.h"

namespace rob::motion {

namespace {

/// [choice] So many legs are looked at, and more of short ones: until they take so many times the
/// mean's time.
constexpr std::size_t kLegs = 3;
constexpr double kMeans = 3;

double least_time(const RobotModel& robot, const ShapedLeg& leg) {
  return leg.length() / greatest_rate(robot, leg, leg.at(leg.length() / 2));
}

}  // namespace

/// The i-th item that has not been taken up, as far as it is known.
const PathItem* PathPlanner::coming(std::size_t at) const {
  return at < pending_.size() ? &pending_[at] : nullptr;
}

/// What follows a leg without a stop, and the corners as far as they can be foretold.
Course PathPlanner::course_from(const ShapedLeg& leg) {
  Course course;
  course.legs.push_back(shape({leg.segment, leg.stretch}, leg.begin));
  course.taken = into_;
  course.square = entry_;
  double time = least_time(robot_, leg);
  const std::size_t most = leg.goes_on() ? kMostParts : kMostLegs;
  while (!course.whole && course.legs.size() < most) {
    const std::size_t count = course.legs.size();
    if (count >= kLegs && time > kMeans * mean_time()) return course;
    const PathItem* const item = coming(count - 1);
    if (course.legs.back().segment.guard.present() || (item == nullptr && nothing_comes())) {
      course.whole = true;
      return course;
    }
    if (item == nullptr) return course;
    const SegmentDescriptor& next = item->segment;
    if ((moves(next) && !has_way(next)) || next.generation <= ring_.over()) return course;
    if (!has_way(next) || next.from_rest || !extend(course, *item)) course.whole = true;
    time += least_time(robot_, course.legs.back());
  }
  return course;
}

/// By a leg, and the corner into it; false where only a stop leads to it.
bool PathPlanner::extend(Course& course, const PathItem& next) {
  const ShapedLeg& last = course.legs.back();
  const ShapedLeg leg = shape(next, last.end());
  const double taken = course.turns.empty() ? course.taken.value_or(0) : course.turns.back().half;
  const bool ends = coming(course.legs.size()) == nullptr && nothing_comes();
  const double longest = std::min(last.length() - taken, ends ? leg.length() : leg.length() / 2);
  std::optional<Turn> turn = rehearsal_.turn(last, leg, longest);
  if (!turn) return false;
  course.turns.push_back(std::move(*turn));
  course.legs.push_back(leg);
  return true;
}

/// A run on an arm that begins with a curve: the more is known of it, the better is its mean.
bool PathPlanner::begins_with_curve() const {
  if (open_ || pending_.empty() || !robot_.tool_coordinates) return false;
  const PathItem& first = pending_.front();
  return first.segment.ahead.window > 0 && first.stretch && first.stretch->goes_on;
}

/// The number of waiting items that belong to the curve at their front; 0 if there is no curve, or
/// its end is not known yet.
std::size_t PathPlanner::parts_of_curve() const {
  for (std::size_t i = 0; i < pending_.size() && pending_[i].stretch; ++i)
    if (!pending_[i].stretch->goes_on) return i + 1;
  return 0;
}

/// The motions on the first items as the program commanded them, each from rest. Empty if one has
/// path events, or begins before these items.
std::vector<PathItem> PathPlanner::legs_of(std::size_t items) const {
  std::vector<PathItem> legs;
  for (std::size_t i = 0; i < items; ++i) {
    for (const PathStretch::Member& member : pending_[i].stretch->members) {
      if (member.begins) legs.push_back({member.segment, nullptr});
      if (legs.empty() || member.segment.on_the_way.size() > 0) return {};
      if (legs.size() > 1) legs.back().segment.from_rest = true;
    }
  }
  return legs;
}

/// Replaces the waiting curve by its legs if stops at all of its points are faster. Returns whether
/// it did.
bool PathPlanner::gives_up_curve() {
  const std::size_t items = parts_of_curve();
  const std::vector<PathItem> legs = legs_of(items);
  if (legs.size() < 2) return false;
  Course course;
  for (std::size_t i = 0; i < items; ++i)
    course.legs.push_back(shape(pending_[i], i == 0 ? known_ : course.legs.back().end()));
  course.turns.resize(items - 1);
  double left = rehearsal_.together(course);
  for (const PathItem& leg : legs)
    if (left > 0 && has_way(leg.segment)) left -= rehearsal_.apart(shape(leg, known_));
  if (left <= 0) return false;
  pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(items));
  pending_.insert(pending_.begin(), legs.begin(), legs.end());
  return true;
}

/// The program adds to a curve leg after leg, so it is worth waiting for more of it. [choice] four
/// legs in two periods: a program that has to measure or wait between them is slower.
bool PathPlanner::curve_grows() {
  constexpr std::uint64_t kPeriods = 2;
  constexpr std::size_t kSome = 4;
  const std::uint64_t now = ring_.periods.load(std::memory_order_relaxed);
  grown_ += merger_.grown();
  if (grown_ >= kSome) {
    grown_ = 0;
    grows_until_ = now + kPeriods;
  }
  return now < grows_until_;
}

/// How the run is driven that begins with that leg.
void PathPlanner::begin_on_arm(ShapedLeg& leg) {
  const Rehearsal::Beginning how = rehearsal_.beginning(course_from(leg));
  if (how.stands && leg.motion.path == nullptr) return stand_alone(leg);
  leg.acceleration *= how.share;
  window_ *= how.share;
}

/// Whether the corner out of the open leg is faster than a stop.
bool PathPlanner::pays() {
  Course course = course_from(*open_);
  if (course.turns.empty()) return false;
  course.turns[0] = *turn_;
  return rehearsal_.pays(course, window_);
}

}  // namespace rob::motion
