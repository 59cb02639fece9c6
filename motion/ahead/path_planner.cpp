#include "motion/ahead/path_planner.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/ahead/mean_shift.h"
#include "motion/ahead/overlap.h"
#include "motion/ahead/run_mean.h"

namespace rob::motion {

namespace {

/// Pieces that a corner, or the way to the next node of a leg, may take.
constexpr std::size_t kSpare = 512;

constexpr double kSoon = PieceWriter::kSoon;
constexpr double kLastChance = PieceWriter::kLastChance;

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
      ring_(ring),
      legs_(robot, ring, single),
      intake_(robot, buffer, ring, legs_.most_members()),
      ahead_(robot, intake_, ring),
      pieces_(ring) {}

bool PathPlanner::work() {
  const bool dropped = ring_.drop_asked();
  const bool closed = intake_.closed();  // before looking: all that was pushed is then seen
  if (dropped) drop();
  const std::size_t room_before = intake_.room();
  bool worked = dropped;
  for (fetch(); advance(); fetch()) worked = true;
  worked = worked || intake_.room() != room_before;
  const bool all_here = closed && !open_ && intake_.items().empty() && !intake_.holds();
  const bool published = pieces_.work(ring_.share.load(std::memory_order_relaxed));
  ring_.closed.store(all_here, std::memory_order_release);
  return worked || published;
}

/// All that has been taken, and all that waits, is given up.
void PathPlanner::drop() {
  std::uint32_t number = 0;
  std::uint32_t generation = 0;
  const auto give_up = [&](const SegmentDescriptor& segment) {
    number = segment.number;
    generation = segment.generation;
  };
  if (open_) give_up(open_->segment);
  if (next_) give_up(next_->segment);
  intake_.drop(give_up);
  open_.reset();
  next_.reset();
  turn_.reset();
  completing_ = false;
  before_ = kAny;
  pieces_.drop();
  ahead_.forget();
  ring_.dropped(number, generation);
}

/// One step; false where there is none to be made now.
bool PathPlanner::advance() {
  if (pieces_.room() < kSpare) return pieces_.narrow();
  if (completing_) return go_on();
  if (!legs_.fits()) return pieces_.narrow() || give_up_corner();
  if (!open_) return begin_run();
  if (turn_) return go_on();
  return intake_.items().empty() ? decide_alone() : join_next();
}

bool PathPlanner::begin_run() {
  const bool unknown = intake_.items().empty() || intake_.awaits_curve();
  if (unknown && intake_.holds()) {
    if (intake_.curve_grows() || !pieces_.guide_within(kSoon, kAny)) return false;
    intake_.flush();  // it stands: what is known has to do
    return true;
  }
  if (intake_.items().empty()) return false;
  if (intake_.begins_with_curve() && !intake_.full(true) && intake_.curve_grows()) return false;
  if (robot_.tool_coordinates && gives_up_curve()) return true;
  const PathItem next = intake_.take();
  if (!has_way(next.segment) || next.segment.generation <= ring_.over()) {
    legs_.write_at(next, pieces_.known());
    return true;
  }
  pieces_.begin_run();
  ahead_.begin_run();
  window_ = next.segment.ahead.window;
  alone_ = pauses_ = false;
  wait_ = 0;
  ShapedLeg leg = shaped_leg(robot_, next, pieces_.known());
  leg.before = before_;
  leg.starts = true;
  if (averages_sigma()) {
    begin_on_arm(leg);
  } else if (ahead_.stands_after(leg, 0, window_)) {
    stand_alone(leg);
  } else {
    const double share = share_for_bends(robot_, leg, intake_.items());
    leg.acceleration *= share;
    window_ *= share;
  }
  pieces_.set_mean({mean_time(), averages_sigma(), alone_, pauses_});
  open(leg);
  return true;
}

/// How the run is driven that begins with that leg.
void PathPlanner::begin_on_arm(ShapedLeg& leg) {
  const Rehearsal::Beginning how = ahead_.beginning(leg, 0, window_);
  if (how.stands && leg.motion.path == nullptr) return stand_alone(leg);
  leg.acceleration *= how.share;
  window_ *= how.share;
}

/// The leg comes to rest at both ends: it gets the mean that is best for it, or for it and an
/// overlap with the next leg.
void PathPlanner::stand_alone(ShapedLeg& leg) {
  LegAlone made = alone(robot_, leg);
  if (const auto next = ahead_.next_alone(leg)) made = with_overlap(robot_, leg, *next, made);
  leg.acceleration *= made.share;
  window_ = made.pauses ? made.average : window_ * made.share;
  alone_ = leg.motion.path == nullptr;
  pauses_ = made.pauses;
}

/// Replaces the waiting curve by its legs if stops at all of its points are faster. Returns whether
/// it did.
bool PathPlanner::gives_up_curve() {
  const std::size_t items = intake_.parts_of_curve();
  const std::vector<PathItem> legs = intake_.legs_of(items);
  if (legs.size() < 2 || !ahead_.sooner_apart(items, legs, pieces_.known())) return false;
  intake_.replace(items, legs);
  return true;
}

/// The run has one mean: what asks for a longer one accelerates the less.
void PathPlanner::open(const ShapedLeg& leg) {
  open_ = leg;
  sent_ = false;
  const PathPoint end = open_->at(open_->length());
  brakes_ = greatest_control(*open_, end);
  const bool calm = averages_sigma() || open_->goes_on();
  const double held = calm ? 0 : longest_calm_way(robot_, *open_, window_);
  pieces_.begin_leg({open_->end(), held, brakes_});
  const double speed = greatest_rate(robot_, *open_, end);
  const double to_brake = speed * speed / (2 * brakes_);
  PathLeg like;
  like.average = std::max(1, static_cast<int>(std::lround(mean_time() / robot_.reference_period)));
  like.pauses = pauses_;
  like.of_sigma = averages_sigma() && !pauses_;
  legs_.write(*open_, std::max(open_->begin, open_->end() - longest_turn(*open_) - to_brake), like);
  completing_ = false;
  if (alone_ || open_->segment.guard.present()) complete();
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
  return std::max(longest, std::min(pieces_.held(), leg.length() - leg.sent));
}

/// From here on the open leg goes to its target.
bool PathPlanner::complete() {
  completing_ = true;
  pieces_.let_go();
  return true;
}

/// More motions than are looked ahead over end where the open leg does, without a way: it does,
/// too.
bool PathPlanner::give_up_corner() {
  if (!open_ || turn_ || pieces_.more_to_publish()) return false;
  return pieces_.guide_within(kLastChance, kAny) && complete();
}

/// Nothing is known after the open leg.
bool PathPlanner::decide_alone() {
  if (intake_.nothing_comes()) return complete();
  if (!sent_) {
    sent_ = send(open_->length() - longest_turn(*open_));
    return true;
  }
  if (intake_.holds()) {
    if (pieces_.more_to_publish() || !pieces_.guide_within(kSoon, brakes_)) return false;
    if (intake_.curve_grows()) return false;
    intake_.flush();
    return true;
  }
  if (pieces_.more_to_publish() || !pieces_.guide_within(kLastChance, kAny)) return false;
  ring_.late.fetch_add(1, std::memory_order_relaxed);
  return complete();
}

bool PathPlanner::join_next() {
  const SegmentDescriptor& next = intake_.items().front().segment;
  const bool longer_mean = next.ahead.window > window_ && window_ == 0;
  if (moves(next) && !has_way(next)) {
    legs_.write_at(next, open_->end());
    keep_within(next.ahead, open_->segment.ahead);
    intake_.take();
    return true;
  }
  if (!moves(next) || next.from_rest || longer_mean ||
      needs_shorter_mean(robot_, window_, intake_.items()))
    return complete();
  const bool known = open_->goes_on() || intake_.items().size() > 1 || next.guard.present() ||
                     intake_.nothing_comes();
  if (!known && sent_ && !pieces_.guide_within(kSoon, brakes_)) return false;
  if (!known && !sent_) {
    sent_ = send(open_->length() - longest_turn(*open_));
    return true;
  }
  if (robot_.tool_coordinates && !open_->goes_on() && gives_up_curve()) return true;
  return join(next);
}

/// The open leg ends with a corner into the next one, or at rest.
bool PathPlanner::join(const SegmentDescriptor& next) {
  next_ = shaped_leg(robot_, intake_.items().front(), open_->end());
  next_->ends = ahead_.ends_at_rest(next, 0);
  if (next.ahead.window > window_) next_->acceleration *= window_ / next.ahead.window;
  turn_ = ahead_.corner(*open_, *next_, 0, window_, false);
  if (turn_ && averages_sigma() && !open_->goes_on() && !ahead_.pays(*open_, *turn_, window_))
    turn_.reset();
  if (turn_) {
    intake_.take();
    return true;
  }
  next_.reset();
  return complete();
}

/// The rest of the open leg: to its target, or around its corner.
bool PathPlanner::go_on() {
  if (turn_ && turn_->calm < 1 && !calm_corner()) return true;
  if (!send(open_->length() - (turn_ ? turn_->half : 0))) return true;
  before_ = open_->segment.ahead.miss > 0 ? open_->segment.ahead.miss : kAny;
  if (!turn_) return come_to_rest();
  round_corner();
  return true;
}

bool PathPlanner::come_to_rest() {
  if (awaits_room()) return false;
  if (overlap_next()) return true;
  pieces_.end_run();
  open_.reset();
  completing_ = false;
  return true;
}

/// Whether the next leg must wait for room in the ring, and the guide still leaves time to wait.
bool PathPlanner::awaits_room() {
  return pauses_ && !intake_.items().empty() && !legs_.fits() && !pieces_.guide_within(kSoon, kAny);
}

/// Continues the run with the next leg if the two can overlap; false if the run must end here.
bool PathPlanner::overlap_next() {
  if (!pauses_ || !legs_.fits()) return false;
  std::optional<ShapedLeg> leg = ahead_.next_alone(*open_);
  if (!leg) return false;
  const auto overlap = overlap_of(robot_, *open_, *leg, mean_time());
  if (!overlap) return false;
  intake_.take();
  pieces_.rest_on_the_way();
  leg->acceleration *= overlap->share;
  leg->before = before_;
  wait_ = overlap->wait;
  open(*leg);
  return true;
}

/// Into the next leg, which is then open.
void PathPlanner::round_corner() {
  if (turn_->half > 0) {
    scratch_.clear();
    append_turn(robot_, *open_, *next_, *turn_, scratch_);
    pieces_.write(scratch_);
  }
  next_->sent = turn_->half;
  next_->before = before_;
  ahead_.enter(turn_->half);
  turn_.reset();
  open(*next_);
  next_.reset();
}

/// Around the corner to come; false where the ring is full.
bool PathPlanner::calm_corner() {
  const double middle = open_->end();
  const double from = middle - turn_->calm_way;
  if (!send(std::max(open_->sent, from - open_->begin))) return false;
  pieces_.calm_down(from, middle + turn_->calm_way, turn_->calm);
  turn_->calm = 1;  // that is done
  return true;
}

/// Makes pieces of the open leg up to `goal`, m from its beginning; false where the ring is full.
bool PathPlanner::send(double goal) {
  constexpr double kNothing = 1e-12;  // of the leg: rounding of what its corners take
  while (goal - open_->sent > kNothing * open_->length()) {
    if (pieces_.room() < kSpare) return false;
    double to = next_end(goal);
    const double calm = pieces_.calm_end() - open_->begin;
    if (calm > open_->sent + PieceWriter::kSamePlace) to = std::min(to, calm);
    scratch_.clear();
    append_leg(robot_, *open_, open_->sent, to, kAny, scratch_);
    if (open_->sent == 0) scratch_.front().wait = wait_;
    if (open_->motion.path != nullptr && window_ > 0 && !robot_.tool_coordinates)
      bound_by_mean(robot_, *open_, mean_time(), scratch_);
    pieces_.write(scratch_);
    open_->sent = to;
  }
  return true;
}

/// Where the next piece of the open leg ends: on an arm what bounds it changes along a straight
/// line, too.
double PathPlanner::next_end(double goal) const {
  if (!averages_sigma() || alone_) return std::min(goal, next_border(*open_, open_->sent));
  const auto out = turn_ ? std::optional(turn_->half) : std::nullopt;
  const Grading grading = grading_of(robot_, *open_, ahead_.into(), out, mean_time());
  return next_cut(*open_, grading, open_->sent, goal);
}

}  // namespace rob::motion
