#include "motion/ahead/path_merger.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion/ahead/leg_writer.h"

namespace rob::motion {

namespace {

using Eigen::Vector3d;

/// Knots on a straight leg before the first vertex of a curve. [choice] the three controls on the
/// line, and half a knot
constexpr double kLead = 3.5;
/// [choice] Where a leg asks for shorter knots than the curve has: so much shorter at most.
constexpr double kMostDense = 8;
constexpr double kNoLength = 1e-9;  // m
constexpr auto kBeyond = static_cast<std::size_t>(-1);

}  // namespace

PathMerger::PathMerger(const RobotModel& robot, LookAheadBuffer& buffer, std::size_t most_members)
    : robot_(robot), rules_(robot), most_members_(most_members), queue_(robot, rules_, buffer) {}

std::optional<PathItem> PathMerger::next() {
  queue_.look();
  while (true) {
    queue_.take();
    if (run_) {
      if (auto item = settled()) return item;
      if (run_->fit.ended()) {
        run_.reset();
      } else if (!grow()) {
        return std::nullopt;
      }
    } else {
      if (queue_.empty()) queue_.wait();
      if (queue_.empty()) return std::nullopt;
      if (auto item = decide()) return item;
      if (!run_) return std::nullopt;
    }
  }
}

/// m that the corner before the first in the queue wants of it.
double PathMerger::joined_half(const SegmentDescriptor& front) const {
  const bool joined = before_ && !front.from_rest && before_->generation == front.generation;
  return joined ? before_wanted_ : 0;
}

/// Hands out the first in the queue as it is, or begins a curve where it crowds or the next leg
/// does. None: a curve has begun, or more must be known.
std::optional<PathItem> PathMerger::decide() {
  const SegmentDescriptor& front = queue_.front().segment;
  if (!rules_.mergeable(front)) return hand_out();
  const LegQueue::Next second = queue_.next_way(0);
  if (!second.known) return std::nullopt;
  if (second.segment == nullptr || !joins(front, *second.segment)) return hand_out();
  const double before = joined_half(front);
  const auto begins = queue_.crowd_begins(0, second, before);
  if (!begins) return std::nullopt;
  if (*begins) {
    begin_run(before);
    return std::nullopt;
  }
  if (!rules_.mergeable(*second.segment)) return hand_out();
  const LegQueue::Next third = queue_.next_way(second.at);
  if (!third.known) return std::nullopt;
  if (third.segment == nullptr || !joins(*second.segment, *third.segment)) return hand_out();
  const auto follows = queue_.crowd_begins(second.at, third, queue_.wanted(0, second));
  if (!follows) return std::nullopt;
  if (!*follows) return hand_out();
  begin_run(before);
  return std::nullopt;
}

/// The first in the queue, as it is.
PathItem PathMerger::hand_out() {
  LegQueue::Waiting& waiting = queue_.front();
  PathItem item{waiting.segment, waiting.part};
  if (!waiting.begins && !item.stretch) item.stretch = std::make_shared<PathStretch>();
  before_.reset();
  if (has_way(waiting.segment) && !waiting.segment.guard.present()) {
    before_wanted_ = queue_.wanted(0, queue_.next_way(0));
    before_ = waiting.segment;
  }
  queue_.pop_front();
  return item;
}

/// Its first `length` m, as an item.
PathItem PathMerger::head_of_front(double length) {
  const LegQueue::Waiting whole = queue_.front();
  queue_.split_front(length);
  before_.reset();
  PathItem item{whole.segment, nullptr};
  item.segment.ahead.length = length;
  item.segment.target = queue_.front().segment.ahead.from;
  auto stretch = whole.segment.path != nullptr
                     ? part_of_line(whole.segment, 0, length / whole.segment.ahead.length)
                     : std::make_shared<PathStretch>();
  if (whole.segment.path != nullptr) lie_on(*stretch, item.segment);
  stretch->members.push_back({whole.segment, 0, whole.segment.ahead.length, whole.begins, 0, 0});
  stretch->goes_on = true;
  item.stretch = std::move(stretch);
  return item;
}

/// Begins a curve on the last part of the first in the queue, or on all of it where it is short.
void PathMerger::begin_run(double before) {
  const SegmentDescriptor& front = queue_.front().segment;
  const LegQueue::Next second = queue_.next_way(0);
  const SegmentDescriptor& like = rules_.mergeable(*second.segment) ? *second.segment : front;
  const bool by_jerk = queue_.rounds_by_jerk();
  const MergeRules::Knots knots = rules_.knots_for(like, by_jerk);
  const double lead = kLead * knots.apart;
  grown_ = 0;
  run_.emplace(knots);
  run_->members.reserve(most_unsettled() + 1);  // memory that is not touched costs nothing
  if (front.ahead.length > before + lead) {
    run_->head = head_of_front(front.ahead.length - lead);
    run_->fit.begin_straight(rules_.begin_of(front), rules_.direction(front));
  } else {
    run_->fit.begin(rules_.begin_of(front));
  }
  run_->end.q = front.ahead.from;
  append_front();
}

/// The ring holds one half of the motions that may be ahead, and a few items wait for it. A curve
/// ends where it would have more than the rest before its first window is full.
std::size_t PathMerger::most_unsettled() const {
  constexpr std::size_t kMost = 4096;  // [choice] 6 MB, where so many are needed
  const auto half = static_cast<std::size_t>(short_ahead(robot_)) / 2;
  return std::min(kMost, half - std::min(half / 2, 8 * most_members_));
}

/// The curve goes on along the first in the queue, or ends; false: that is not known yet.
bool PathMerger::grow() {
  if (queue_.empty()) {
    if (queue_.final()) run_->fit.end();
    return queue_.final();
  }
  const SegmentDescriptor& front = queue_.front().segment;
  const SegmentDescriptor& last = run_->members.back().segment;
  const bool stands = moves(front) && !has_way(front) && !front.guard.present();
  if (stands && front.ahead.miss >= last.ahead.miss && has_way(last)) {
    append_front();
    return true;
  }
  const bool full = run_->members.size() >= most_unsettled();
  if (full || !rules_.mergeable(front) || !joins(last, front)) {
    run_->fit.end();
    before_ = last;
    before_wanted_ = 0;
    return true;
  }
  const LegQueue::Next next = queue_.next_way(0);
  if (!next.known) return false;
  const double tail = LegQueue::kTail * run_->fit.knot();
  const bool crowds = queue_.crowded(0, next, run_->last_wanted) ||
                      front.ahead.length < tail + queue_.wanted(0, next);
  crowds ? append_front() : end_on_front();
  return true;
}

void PathMerger::append_front() {
  LegQueue::Waiting& front = queue_.front();
  const SegmentDescriptor& segment = front.segment;
  Member member{segment, run_->vertices - 1, run_->vertices - 1, 0, front.begins, front.part};
  if (has_way(segment)) {
    const double dense = run_->fit.knot() / rules_.knots_for(segment, run_->by_jerk).apart;
    run_->fit.append(rules_.end_of(segment), rules_.tolerance(segment),
                     std::clamp(dense, 1.0, kMostDense));
    run_->last_wanted = std::max(front.wanted, 0.0);
    member.to = run_->vertices++;
  }
  run_->members.push_back(std::move(member));
  queue_.pop_front();
  ++grown_;
}

/// It is long: the curve ends on its first part.
void PathMerger::end_on_front() {
  const LegQueue::Waiting& front = queue_.front();
  Member member{front.segment, run_->vertices - 1, kBeyond, 0, front.begins, front.part};
  const double way = run_->fit.end_straight(rules_.direction(front.segment));
  member.beyond = front.segment.ahead.length - way;
  run_->members.push_back(std::move(member));
  if (member.beyond > kNoLength) {
    queue_.split_front(way);
    before_.reset();
    return;
  }
  before_ = front.segment;
  before_wanted_ = 0;
  queue_.pop_front();
}

/// u at the end of what a member has of the curve.
double PathMerger::end_of(const Member& member) const {
  return member.to == kBeyond ? run_->fit.length() : run_->fit.at_vertex(member.to);
}

/// Those that lie on what is settled, and may be handed out in one item.
std::size_t PathMerger::settled_members() const {
  constexpr double kRounding = 1e-9;
  const std::vector<Member>& members = run_->members;
  const double settled = run_->fit.settled() + kRounding;
  std::size_t count = 0;
  while (count < members.size()) {
    const Member& member = members[count];
    const bool stands = member.from == member.to;
    if (count >= most_members_ && !stands) break;
    if (member.to == kBeyond ? !run_->fit.ended() : end_of(member) > settled) break;
    ++count;
  }
  return count;
}

/// Hands out the settled part of the curve, up to the end of a motion.
std::optional<PathItem> PathMerger::settled() {
  while (true) {
    const std::size_t members = settled_members();
    if (members > 0 && run_->head) return head_of_run();
    if (members > 0 && end_of(run_->members[members - 1]) > run_->handed) return item_of(members);
    if (!run_->fit.ready()) return std::nullopt;
    run_->fit.settle();
  }
}

/// Where a motion ends on the curve is known once that is settled.
PathItem PathMerger::head_of_run() {
  PathItem head = *std::exchange(run_->head, std::nullopt);
  auto stretch = std::make_shared<PathStretch>(*head.stretch);
  if (!stretch->axes.nodes().empty()) lie_on(*stretch, head.segment);
  PathStretch::Member& whole = stretch->members.front();
  const CurvePart part{0, end_of(run_->members.front())};
  const double beyond = run_->members.front().beyond;
  whole.end = head.segment.ahead.length + part.end * run_->fit.knot() + beyond;
  whole.before = head.segment.ahead.length;
  whole.beyond = beyond;
  place_events(whole.before, part, beyond, whole.segment);
  head.stretch = std::move(stretch);
  return head;
}

/// A leg has `before` m, then a part of the curve, then `beyond` m. σ goes with u on the curve, not
/// with the way: its events get the shares of σ at which the leg has their places.
void PathMerger::place_events(double before, const CurvePart& part, double beyond,
                              SegmentDescriptor& segment) const {
  const double length = segment.ahead.length;
  const double knot = run_->fit.knot();
  const double total = before + (part.end - part.begin) * knot + beyond;
  segment.on_the_way.change_each([&](PathEvent& event) {
    const double way = std::clamp(event.share, 0.0, 1.0) * length;
    double sigma = way;
    if (way >= length - beyond) {
      sigma = total - (length - way);
    } else if (way > before) {
      const Vector3d place = rules_.begin_of(segment) + way * rules_.direction(segment);
      sigma = before + (run_->fit.at_place(part.begin, part.end, place) - part.begin) * knot;
    }
    event.share = sigma / total;
  });
}

PathItem PathMerger::item_of(std::size_t members) {
  const CurveFit& fit = run_->fit;
  const Member last = run_->members[members - 1];
  const double begin = run_->handed;
  const double end = std::min(end_of(last), fit.settled());
  auto stretch = std::make_shared<PathStretch>();
  PathItem item{last.segment, nullptr};
  LegBounds& bounds = item.segment.ahead;
  // A motion without a way has no line, and asks for nothing along the curve.
  for (std::size_t i = 0; i < members; ++i)
    if (has_way(run_->members[i].segment)) bounds = run_->members[i].segment.ahead;
  for (std::size_t i = 0; i < members; ++i) {
    const Member& member = run_->members[i];
    stretch->members.push_back({member.segment, (fit.at_vertex(member.from) - begin) * fit.knot(),
                                (end_of(member) - begin) * fit.knot() + member.beyond,
                                member.begins, 0, member.beyond});
    place_events(0, {fit.at_vertex(member.from), end_of(member)}, member.beyond,
                 stretch->members.back().segment);
    if (!has_way(member.segment)) continue;
    bounds.speed = std::max(bounds.speed, member.segment.ahead.speed);
    bounds.miss = std::min(bounds.miss, member.segment.ahead.miss);
    bounds.acceleration = std::min(bounds.acceleration, member.segment.ahead.acceleration);
    bounds.window = std::max(bounds.window, member.segment.ahead.window);
  }
  item.segment.from_rest = begin == 0 && run_->members.front().segment.from_rest;
  stretch->goes_on = last.beyond > 0 || !fit.ended() || members < run_->members.size();
  bounds.length = (end - begin) * fit.knot();
  bounds.first = stretch->members.front().end;
  bounds.last = bounds.length - stretch->members.back().begin;
  bounds.from = run_->end.q;
  stretch->axes = robot_.tool_coordinates ? axes_of_arm({begin, end}, *stretch, bounds)
                                          : rules_.axes_of_table(fit, {begin, end}, bounds.from);
  bounds.line = nullptr;
  if (stretch->goes_on) item.segment.target = stretch->axes.nodes().back().q;
  run_->end.q = item.segment.target;
  note_slopes(fit, {begin, end}, *stretch);
  item.segment.path = &stretch->axes;
  item.stretch = std::move(stretch);
  run_->handed = end;
  run_->fit.drop(end);
  if (last.to != kBeyond) run_->fit.drop_vertices(last.to);
  run_->members.erase(run_->members.begin(),
                      run_->members.begin() + static_cast<std::ptrdiff_t>(members));
  return item;
}

/// The axes of an arm along a part of the curve; they go on from the end of the last part.
JointPath PathMerger::axes_of_arm(const CurvePart& part, const PathStretch& stretch,
                                  const LegBounds& like) {
  const double scale = part.end - part.begin;
  const SegmentDescriptor& last = stretch.members.back().segment;
  PathPoint first = run_->end;
  if (first.qd.size() > 0) first = {first.q, first.qd * scale, first.qdd * (scale * scale)};
  JointPath axes = follow_curve(robot_, run_->fit, part, stretch, like, first);
  if (!stretch.goes_on) axes = ending_at(axes, last.target);
  const JointPath::Node& end = axes.nodes().back();
  run_->end = {end.q, end.qd / scale, end.qdd / (scale * scale)};
  return axes;
}

}  // namespace rob::motion
