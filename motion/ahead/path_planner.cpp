#include "motion/ahead/path_planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/ahead/mean_shift.h"
#include "motion/ahead/run_mean.h"

namespace rob::motion {

namespace {

/// The open leg's successor, and two after it.
constexpr std::size_t kPending = 3;

/// Pieces that a corner, or the way to the next node of a leg, may take.
constexpr std::size_t kSpare = 512;

double greatest_rotary_slope(const RobotModel& robot, const PathPoint& place) {
  double most = 0;
  for (int i = 0; i < robot.axis_count(); ++i)
    if (robot.axes[static_cast<std::size_t>(i)].kind == AxisKind::Rotary)
      most = std::max(most, std::abs(place.qd[i]));
  return most;
}

}  // namespace

PathPlanner::PathPlanner(const RobotModel& robot, LookAheadBuffer& buffer, PathRing& ring,
                         std::size_t single)
    : robot_(robot),
      buffer_(buffer),
      ring_(ring),
      legs_(robot, ring, single),
      merger_(robot, buffer, legs_.most_members()),
      rehearsal_(robot) {}

bool PathPlanner::work() {
  const bool dropped = ring_.drop_asked();
  const bool closed = buffer_.closed();  // before looking: all that was pushed is then seen
  if (dropped) drop();
  const std::size_t room_before = buffer_.room();
  bool worked = dropped;
  for (fetch(); advance(); fetch()) worked = true;
  worked = worked || buffer_.room() != room_before;
  const bool all_here = closed && !open_ && pending_.empty() && !merger_.holds();
  const double share = ring_.share.load(std::memory_order_relaxed);
  const bool anew = share != std::exchange(share_, share);
  if (anew || end_ != ring_.end()) {
    worked = true;
    publish(anew);
  }
  ring_.closed.store(all_here, std::memory_order_release);
  return worked;
}

/// All that has been taken, and all that waits, is given up.
void PathPlanner::drop() {
  std::uint32_t number = open_ ? open_->segment.number : 0;
  std::uint32_t generation = open_ ? open_->segment.generation : 0;
  const auto give_up = [&](const SegmentDescriptor& segment) {
    number = segment.number;
    generation = segment.generation;
  };
  if (next_) give_up(next_->segment);
  for (const PathItem& item : pending_) give_up(item.segment);
  pending_.clear();
  merger_.drop(give_up);
  while (const SegmentDescriptor* next = buffer_.next_segment()) {
    give_up(*next);
    buffer_.pop_segment();
  }
  open_.reset();
  next_.reset();
  turn_.reset();
  completing_ = false;
  before_ = kAny;
  end_ = ring_.end();  // drafts are not path
  published_ = -kAny;  // and nothing lies ahead of the guide
  speeds_.begin();
  rehearsal_.forget();
  ring_.dropped(number, generation);
}

std::size_t PathPlanner::most_pending() const {
  if (robot_.tool_coordinates) return begins_with_curve() ? kMostParts : kMostLegs;
  const bool awaits = !open_ && !pending_.empty() && awaits_curve(robot_, pending_);
  return awaits ? kMostBeforeCurve : kPending;
}

void PathPlanner::fetch() {
  while (pending_.size() < most_pending()) {
    auto next = merger_.next();
    if (!next) return;
    pending_.push_back(*std::move(next));
  }
}

/// s of the mean of the present run: whole periods.
double PathPlanner::mean_time() const noexcept { return rehearsal_.mean_time(window_); }

std::size_t PathPlanner::room() const noexcept {
  return ring_.room() - static_cast<std::size_t>(end_ - ring_.end());
}

/// One step; false where there is none to be made now.
bool PathPlanner::advance() {
  if (room() < kSpare) return narrow();
  if (completing_) return go_on();
  if (!legs_.fits()) return narrow() || give_up_corner();
  if (!open_) return begin_run();
  if (turn_) return go_on();
  return pending_.empty() ? decide_alone() : join_next();
}

ShapedLeg PathPlanner::shape(const PathItem& item, double begin) const {
  ShapedLeg leg = shaped_leg(robot_, item.segment, begin);
  leg.stretch = item.stretch;
  return leg;
}

bool PathPlanner::begin_run() {
  if ((pending_.empty() || awaits_curve(robot_, pending_)) && merger_.holds()) {
    if (curve_grows() || !guide_within(kSoon, kAny)) return false;
    merger_.flush();  // it stands: what is known has to do
    return true;
  }
  if (pending_.empty()) return false;
  if (begins_with_curve() && pending_.size() < most_pending() && curve_grows()) return false;
  if (robot_.tool_coordinates && gives_up_curve()) return true;
  const PathItem next = pending_.front();
  pending_.pop_front();
  if (!has_way(next.segment) || next.segment.generation <= ring_.over()) {
    legs_.write_at(next, known_);
    return true;
  }
  if (end_ != ring_.end()) publish(false);  // the run before has a mean of its own
  window_ = next.segment.ahead.window;
  speeds_.begin();
  into_.reset();
  entry_ = 0;
  calm_ = {};
  alone_ = pauses_ = false;
  wait_ = 0;
  ShapedLeg leg = shape(next, known_);
  leg.before = before_;
  leg.starts = true;
  if (averages_sigma()) {
    begin_on_arm(leg);
  } else if (stands_after(leg)) {
    stand_alone(leg);
  } else {
    const double share = share_for_bends(robot_, leg, pending_);
    leg.acceleration *= share;
    window_ *= share;
  }
  open(leg);
  return true;
}

/// Nothing comes behind what waits here.
bool PathPlanner::nothing_comes() const {
  const bool closed = buffer_.closed();  // before looking: all that was pushed is then seen
  return closed && buffer_.next_segment() == nullptr && !merger_.holds();
}

/// The run has one mean: what asks for a longer one accelerates the less.
void PathPlanner::open(const ShapedLeg& leg) {
  open_ = leg;
  sent_ = false;
  held_ = averages_sigma() || open_->goes_on() ? 0 : longest_calm_way(robot_, *open_, window_);
  const PathPoint end = open_->at(open_->length());
  const double speed = greatest_rate(robot_, *open_, end);
  const double brakes = speed * speed / (2 * greatest_control(*open_, end));
  PathLeg like;
  like.average = std::max(1, static_cast<int>(std::lround(mean_time() / robot_.reference_period)));
  like.pauses = pauses_;
  like.of_sigma = averages_sigma() && !pauses_;
  legs_.write(*open_, std::max(open_->begin, open_->end() - longest_turn(*open_) - brakes), like);
  completing_ = alone_ || open_->segment.guard.present();
}

/// More motions than are looked ahead over end where the open leg does, without a way: it does,
/// too.
bool PathPlanner::give_up_corner() {
  if (!open_ || turn_ || more_to_publish() || !guide_within(kLastChance, kAny)) return false;
  completing_ = true;
  return true;
}

/// Nothing is known after the open leg.
bool PathPlanner::decide_alone() {
  if (nothing_comes()) {
    completing_ = true;
    return true;
  }
  if (!sent_) {
    sent_ = send(open_->length() - longest_turn(*open_));
    return true;
  }
  if (merger_.holds()) {
    const double control = greatest_control(*open_, open_->at(open_->length()));
    if (more_to_publish() || !guide_within(kSoon, control) || curve_grows()) return false;
    merger_.flush();
    return true;
  }
  if (more_to_publish() || !guide_within(kLastChance, kAny)) return false;
  ring_.late.fetch_add(1, std::memory_order_relaxed);
  completing_ = true;
  return true;
}

bool PathPlanner::join_next() {
  const SegmentDescriptor& next = pending_.front().segment;
  const bool longer_mean = next.ahead.window > window_ && window_ == 0;
  if (moves(next) && !has_way(next)) {
    legs_.write_at(next, open_->end());
    keep_within(next.ahead, open_->segment.ahead);
    pending_.pop_front();
    return true;
  }
  if (!moves(next) || next.from_rest || longer_mean ||
      needs_shorter_mean(robot_, window_, pending_)) {
    completing_ = true;
    return true;
  }
  const bool known =
      open_->goes_on() || pending_.size() > 1 || next.guard.present() || nothing_comes();
  if (!known && sent_ && !guide_within(kSoon, brakes_at_end())) return false;
  if (!known && !sent_) {
    sent_ = send(open_->length() - longest_turn(*open_));
    return true;
  }
  if (robot_.tool_coordinates && !open_->goes_on() && gives_up_curve()) return true;
  next_ = shape(pending_.front(), open_->end());
  next_->ends = ends_at_rest(next);
  if (next.ahead.window > window_) next_->acceleration *= window_ / next.ahead.window;
  turn_ = corner(*open_, *next_, false);
  if (turn_ && averages_sigma() && !open_->goes_on() && !pays()) turn_.reset();
  if (!turn_) {
    next_.reset();
    completing_ = true;
  } else {
    pending_.pop_front();
  }
  return true;
}

/// None where a stop is as fast, or all that is possible.
std::optional<Turn> PathPlanner::corner(const ShapedLeg& leg, const ShapedLeg& next,
                                        bool from_rest) const {
  const bool whole_run =
      from_rest && (pending_.size() > 1 ? !goes_on_behind(next) : ends_at_rest(next.segment));
  TurnBounds bounds{std::min(leg.length() - leg.sent, share_of_next(next)), mean_time(),
                    robot_.tool_coordinates, from_rest, whole_run};
  std::optional<Turn> made = make_turn(robot_, leg, next, bounds);
  if (made || robot_.tool_coordinates || !goes_on_behind(next)) return made;
  bounds.to_rest = false;
  return make_turn(robot_, leg, next, bounds);
}

/// Whether the leg after the corner has another at its end, which is faster than a stop.
bool PathPlanner::goes_on_behind(const ShapedLeg& next) const {
  if (pending_.size() < 2) return false;
  const SegmentDescriptor& behind = pending_[1].segment;
  if (!has_way(behind) || behind.from_rest) return false;
  const ShapedLeg third = shape(pending_[1], next.end());
  return make_turn(robot_, next, third,
                   {std::min(next.length(), third.length()) / 2, mean_time(), false, true})
      .has_value();
}

/// As far as it is known what comes after it.
bool PathPlanner::ends_at_rest(const SegmentDescriptor& next) const {
  if (next.guard.present()) return true;
  if (pending_.size() < 2) return nothing_comes();
  const SegmentDescriptor& behind = pending_[1].segment;
  return !moves(behind) || behind.from_rest;
}

/// What the corner into the next leg may take of it: what the corner out of it leaves, or half.
double PathPlanner::share_of_next(const ShapedLeg& next) const {
  const double length = next.length();
  if (ends_at_rest(next.segment)) return length;  // there is no corner
  if (pending_.size() < 2) return length / 2;
  if (!has_way(pending_[1].segment)) return length / 2;
  const double other = wanted_half(robot_, next, shape(pending_[1], next.end()));
  return std::max(length / 2, length - other);
}

/// The rest of the open leg: to its target, or around its corner.
bool PathPlanner::go_on() {
  if (turn_ && turn_->calm < 1 && !calm_corner()) return true;
  if (!send(open_->length() - (turn_ ? turn_->half : 0))) return true;
  before_ = open_->segment.ahead.miss > 0 ? open_->segment.ahead.miss : kAny;
  if (!turn_) {
    if (awaits_room()) return false;
    if (overlap_next()) return true;
    if (end_ > 0) ring_.set_run_end(end_ - 1, true);
    speeds_.end_at_rest();
    open_.reset();
    completing_ = false;
    return true;
  }
  if (turn_->half > 0) {
    scratch_.clear();
    append_turn(robot_, *open_, *next_, *turn_, scratch_);
    write(scratch_);
  }
  next_->sent = turn_->half;
  next_->before = before_;
  into_ = turn_->half;
  entry_ = rehearsal_.square_after();
  turn_.reset();
  open(*next_);
  next_.reset();
  return true;
}

/// The longest leg that a corner at its end can use, whatever follows (motion.md).
double PathPlanner::longest_turn(const ShapedLeg& leg) const {
  if (leg.goes_on()) return 0;
  const LegBounds& zone = leg.segment.ahead;
  const PathPoint end = leg.at(leg.length());
  const double rotary = greatest_rotary_slope(robot_, end);
  const double miss = std::min(zone.miss, rotary > 0 ? zone.turn / rotary : kAny);
  double longest = std::min({leg.length() - leg.sent, zone.lead, zone.last});
  if (zone.share < 1) longest = std::min(longest, zone.share / 2 * leg.length());
  const double speed = greatest_rate(robot_, leg, end);
  if (miss < kAny)
    longest = std::min(longest, speed * std::sqrt(2 * miss / greatest_control(leg, end)));
  return std::max(longest, std::min(held_, leg.length() - leg.sent));
}

/// Makes pieces of the open leg up to `goal`, m from its beginning; false where the ring is full.
bool PathPlanner::send(double goal) {
  constexpr double kNothing = 1e-12;  // of the leg: rounding of what its corners take
  while (goal - open_->sent > kNothing * open_->length()) {
    if (room() < kSpare) return false;
    double to = next_end(goal);
    const double calm = calm_.end - open_->begin;
    if (calm > open_->sent + kRounding) to = std::min(to, calm);
    scratch_.clear();
    append_leg(robot_, *open_, open_->sent, to, kAny, scratch_);
    if (open_->sent == 0) scratch_.front().wait = wait_;
    if (open_->motion.path != nullptr && window_ > 0 && !robot_.tool_coordinates)
      bound_by_mean(robot_, *open_, mean_time(), scratch_);
    write(scratch_);
    open_->sent = to;
  }
  return true;
}

/// Where the next piece of the open leg ends: on an arm what bounds it changes along a straight
/// line, too.
double PathPlanner::next_end(double goal) const {
  if (!averages_sigma() || alone_) return std::min(goal, next_border(*open_, open_->sent));
  const auto out = turn_ ? std::optional(turn_->half) : std::nullopt;
  return next_cut(*open_, grading_of(robot_, *open_, into_, out, mean_time()), open_->sent, goal);
}

void PathPlanner::write(std::vector<Piece>& pieces) {
  for (Piece& piece : pieces) {
    known_ = piece.begin + piece.length;
    if (piece.begin < calm_.end - kRounding) piece.calm_down(calm_.share);
    if (averages_sigma()) {
      speeds_.add(piece);
    } else if (extends_last(piece)) {
      Piece& last = ring_.draft(end_ - 1);
      last.length = known_ - last.begin;
      continue;
    }
    ring_.draft(end_) = piece;
    ring_.set_square(end_, 0);
    ring_.set_run_end(end_, false);
    ++end_;
  }
}

}  // namespace rob::motion
