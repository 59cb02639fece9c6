#include "motion/ahead/leg_queue.h"

#include <algorithm>

namespace rob::motion {

namespace {

/// How many motions in the queue decide on the first: two legs after it, and those between.
constexpr std::size_t kDecide = 5;
/// [choice] A curve pays where a mean bounds the jerk, if so many legs crowd out of so many.
constexpr int kCrowd = 6;
constexpr std::size_t kLegs = 32;
/// How many motions in the queue decide on the first there: the long leg before, and those between.
constexpr std::size_t kDecideOnMean = kLegs + kLegs / 2;

}  // namespace

void LegQueue::take() {
  while (!full()) {
    const SegmentDescriptor* const next = buffer_.next_segment();
    if (next == nullptr) return;
    waiting_.push_back({*next, true, kUnknown, nullptr});
    buffer_.pop_segment();
  }
}

/// The queue holds enough motions to decide on the first, whatever comes after them.
bool LegQueue::full() const {
  if (waiting_.size() < kDecide) return false;
  return !averaged(waiting_.front().segment) || waiting_.size() >= kDecideOnMean;
}

/// A mean of the axes bounds its jerk.
bool LegQueue::averaged(const SegmentDescriptor& segment) const {
  return segment.ahead.window > 0 && !robot_.tool_coordinates;
}

/// Nothing comes after the queue, or we do not wait for it.
bool LegQueue::final() const { return buffer_.next_segment() == nullptr && (closed_ || flushed_); }

/// A curve that begins with the first in the queue rounds its bends by jerk: one of the first two
/// is gentle.
bool LegQueue::rounds_by_jerk() const {
  const SegmentDescriptor* leg = &waiting_.front().segment;
  Next next = next_way(0);
  for (int k = 0; k < 2 && next.segment != nullptr; ++k) {
    if (rules_.bends_gently(*leg, *next.segment)) return true;
    leg = next.segment;
    next = next_way(next.at);
  }
  return false;
}

/// The next motion with a way, if only motions without one lie between.
LegQueue::Next LegQueue::next_way(std::size_t i) const {
  for (std::size_t k = i + 1; k < waiting_.size(); ++k) {
    const SegmentDescriptor& segment = waiting_[k].segment;
    if (has_way(segment)) return {true, &segment, k};
    if (!moves(segment)) return {};
  }
  return {full() || final(), nullptr, 0};
}

/// m that the corner at its end would like to have of it.
double LegQueue::wanted(std::size_t i, const Next& next) {
  if (next.segment == nullptr) return 0;
  Waiting& waiting = waiting_[i];
  if (waiting.wanted == kUnknown) {
    waiting.wanted = rules_.corner_half(waiting.segment, *next.segment);
  }
  return waiting.wanted;
}

/// How long a leg of an arm may be that crowds. An arm chooses between a corner and a stop by their
/// times (PathPlanner): so only what bends gently at both ends crowds as elsewhere, the rest if it
/// is as short as a curve's end.
double LegQueue::longest_on_arm(std::size_t i, const Next& next, double before) {
  constexpr double kAlike = 4;  // [choice] times as much as the other corner one may want
  const SegmentDescriptor& segment = waiting_[i].segment;
  const double after = wanted(i, next);
  const double soon = rules_.soon(segment);
  const bool gentle = next.segment != nullptr && before <= kAlike * after &&
                      rules_.bends_gently(segment, *next.segment) &&
                      !rules_.nearly_straight(segment, *next.segment);
  return gentle ? std::max(soon, before + after)
                : std::min(soon, kTail * rules_.knots_for(segment, false).apart);
}

/// Whether the corners at both ends of a leg, `before` m of it at its beginning, want more than it
/// has, or it is passed too soon.
bool LegQueue::crowded(std::size_t i, const Next& next, double before) {
  const SegmentDescriptor& segment = waiting_[i].segment;
  if (!rules_.mergeable(segment)) return false;
  const double corners = before + wanted(i, next);
  if (corners == 0) return false;
  const double longest = robot_.tool_coordinates ? longest_on_arm(i, next, before)
                                                 : std::max(rules_.soon(segment), corners);
  if (!(segment.ahead.length < longest)) return false;
  if (!averaged(segment)) return true;
  return next.segment != nullptr && rules_.sooner_on_curve(segment, *next.segment);
}

/// Whether a leg and, where a mean bounds the jerk, enough of those after it crowd; none: that is
/// not known yet.
std::optional<bool> LegQueue::crowd_begins(std::size_t i, const Next& next, double before) {
  if (!crowded(i, next, before)) return false;
  if (!averaged(waiting_[i].segment)) return true;
  Next leg = next;
  double taken = wanted(i, next);
  int count = 1;
  for (std::size_t k = 1; k < kLegs && count < kCrowd; ++k) {
    if (leg.segment == nullptr || !rules_.mergeable(*leg.segment)) return false;
    const Next after = next_way(leg.at);
    if (!after.known) return std::nullopt;
    if (after.segment == nullptr || !joins(*leg.segment, *after.segment)) return false;
    const bool crowds = crowded(leg.at, after, taken);
    const double longest = rules_.longest_between(waiting_[i].segment, *leg.segment);
    if (!crowds && !(leg.segment->ahead.length < longest)) return false;
    count += crowds ? 1 : 0;
    taken = wanted(leg.at, after);
    leg = after;
  }
  return count == kCrowd;
}

/// Removes the first `length` m of it; the caller has them.
void LegQueue::split_front(double length) {
  Waiting& waiting = waiting_.front();
  SegmentDescriptor& rest = waiting.segment;
  const double share = length / rest.ahead.length;
  if (rest.path != nullptr) {
    waiting.part = part_of_line(rest, share, 1);
    lie_on(*waiting.part, rest);
    rest.ahead.from = rest.path->nodes().front().q;
  } else {
    rest.ahead.from += share * (rest.target - rest.ahead.from);
  }
  rest.ahead.length -= length;
  rest.from_rest = false;
  waiting.begins = false;
}

}  // namespace rob::motion
