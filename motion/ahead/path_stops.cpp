// The PathPlanner where legs have a stop at both ends.

#include <utility>

#include "motion/ahead/overlap.h"
#include "motion/ahead/path_planner.h"

namespace rob::motion {

/// The leg comes to rest at both ends: it gets the mean that is best for it, or for it and an
/// overlap with the next leg.
void PathPlanner::stand_alone(ShapedLeg& leg) {
  LegAlone made = alone(robot_, leg);
  if (const auto next = next_alone(leg)) made = with_overlap(robot_, leg, *next, made);
  leg.acceleration *= made.share;
  window_ = made.pauses ? made.average : window_ * made.share;
  alone_ = leg.motion.path == nullptr;
  pauses_ = made.pauses;
}

/// Whether the planner knows already that a run begins and ends with this leg.
bool PathPlanner::stands_after(const ShapedLeg& leg) const {
  if (leg.segment.guard.present()) return true;
  if (pending_.empty()) return nothing_comes();
  const SegmentDescriptor& next = pending_.front().segment;
  if (!moves(next) || next.from_rest) return true;
  if (!has_way(next) || leg.motion.path != nullptr || leg.stretch) return false;
  return !corner(leg, shape(pending_.front(), leg.end()), true);
}

/// The same. On an arm a rehearsal compares the stop with a corner.
bool PathPlanner::stands_alone(const ShapedLeg& leg) {
  if (!averages_sigma()) return stands_after(leg);
  return rehearsal_.beginning(course_from(leg)).stands;
}

/// The next motion, if it is a straight leg that comes to rest at both of its ends.
std::optional<ShapedLeg> PathPlanner::next_alone(const ShapedLeg& leg) {
  if (pending_.empty() || leg.segment.guard.present()) return std::nullopt;
  const PathItem item = pending_.front();
  const SegmentDescriptor& next = item.segment;
  if (!has_way(next) || next.from_rest || next.path != nullptr || item.stretch ||
      next.generation <= ring_.over() || next.guard.present() || next.live.present())
    return std::nullopt;
  const ShapedLeg shaped = shape(item, leg.end());
  pending_.pop_front();
  const double mean = std::exchange(window_, next.ahead.window);  // as if it began a run
  const bool stands = stands_alone(shaped);
  window_ = mean;
  pending_.push_front(item);
  return stands ? std::optional(shaped) : std::nullopt;
}

/// Whether the next leg must wait for room in the ring, and the guide still leaves time to wait.
bool PathPlanner::awaits_room() {
  return pauses_ && !pending_.empty() && !legs_.fits() && !guide_within(kSoon, kAny);
}

/// Continues the run with the next leg if the two can overlap; false if the run must end here.
bool PathPlanner::overlap_next() {
  if (!pauses_ || !legs_.fits()) return false;
  std::optional<ShapedLeg> leg = next_alone(*open_);
  if (!leg) return false;
  const auto overlap = overlap_of(robot_, *open_, *leg, mean_time());
  if (!overlap) return false;
  pending_.pop_front();
  if (averages_sigma()) {
    speeds_.end_at_rest();
    publish(false);
    speeds_.begin();
  }
  leg->acceleration *= overlap->share;
  leg->before = before_;
  wait_ = overlap->wait;
  open(*leg);
  return true;
}

}  // namespace rob::motion
