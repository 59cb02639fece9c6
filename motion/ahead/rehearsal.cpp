#include "motion/ahead/rehearsal.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "motion/ahead/overlap.h"

namespace rob::motion {

namespace {

/// [choice] A piece is so much shorter than it is far from where the speed is low.
constexpr double kGrows = 0.2;

/// [choice] m: no piece needs to be shorter.
constexpr double kShortestPiece = 1e-6;

/// [choice] Each mean that is tried is so much shorter than the one before.
constexpr double kLess = 0.7;
constexpr double kLeast = 0.1;

}  // namespace

double next_border(const ShapedLeg& leg, double way) {
  if (leg.motion.path == nullptr) return leg.length();
  const std::span<const JointPath::Node> nodes = leg.motion.path->nodes();
  const double sure = way * (1 + 1e-12) + 1e-12 * leg.length();
  const auto next = std::ranges::upper_bound(
      nodes, sure, {}, [&](const JointPath::Node& node) { return node.time * leg.length(); });
  return next == nodes.end() ? leg.length() : next->time * leg.length();
}

double Grading::length_at(double way) const noexcept {
  const double behind = std::max(way - begin, 0.0);
  const double before = std::max(end - way, 0.0);
  const double from_begin = std::max(first, kGrows * behind);
  const double to_end = std::max(last, kGrows / (1 + kGrows) * before);
  return std::min({longest, from_begin, to_end});
}

Grading grading_of(const RobotModel& robot, const ShapedLeg& leg, std::optional<double> into,
                   std::optional<double> out, double average) {
  constexpr double kParts = 16;  // [choice] of the way within the mean's time, and of its half
  constexpr double kOfCorner = 8;
  const PathPoint middle = leg.at(leg.length() / 2);
  const double speed = greatest_rate(robot, leg, middle);
  const double control = greatest_control(leg, middle);
  const double half = average / kParts * 2;
  const double at_rest = std::max(control * half * half / 2, kShortestPiece);
  const double longest = std::max(speed * average / kParts, kShortestPiece);
  const auto least = [&](std::optional<double> corner) {
    if (!corner) return at_rest;
    return *corner > 0 ? std::max(*corner / kOfCorner, kShortestPiece) : longest;
  };
  return {into.value_or(0), leg.length() - out.value_or(0), least(into), least(out), longest};
}

double next_cut(const ShapedLeg& leg, const Grading& grading, double way, double goal) {
  constexpr double kRest = 1.5;  // of a piece: so much is one
  const double to = std::min(goal, next_border(leg, way));
  const double length = grading.length_at(way);
  return to - way <= kRest * length ? to : way + length;
}

double Rehearsal::mean_time(double window) const noexcept { return whole_periods(robot_, window); }

void Rehearsal::lay(const ShapedLeg& leg, std::optional<double> into, std::optional<double> out,
                    double average) {
  constexpr double kNothing = 1e-12;
  const Grading grading = grading_of(robot_, leg, into, out, average);
  const double goal = leg.length() - out.value_or(0);
  for (double way = into.value_or(0); goal - way > kNothing * leg.length();) {
    const double to =
        average > 0 ? next_cut(leg, grading, way, goal) : std::min(goal, next_border(leg, way));
    append_leg(robot_, leg, way, to, Piece::kAny, pieces_);
    way = to;
  }
}

/// With less acceleration where it would ask for a longer mean.
ShapedLeg Rehearsal::driven(const ShapedLeg& leg, double window) const {
  ShapedLeg calm = leg;
  const double wants = leg.segment.ahead.window;
  if (wants > window) calm.acceleration *= window / wants;
  return calm;
}

/// s until the guide comes to rest at the end of leg `last`.
double Rehearsal::guided(const Course& course, std::size_t first, std::size_t last, double window) {
  const double average = mean_time(window);
  std::optional<double> into;
  if (first == 0) into = course.taken;
  const double square = into ? course.square : 0;
  pieces_.clear();
  std::size_t behind = 0;
  ShapedLeg leg = driven(course.legs[first], window);
  for (std::size_t i = first; i < last; ++i) {
    const Turn& turn = course.turns[i];
    lay(leg, into, turn.half, average);
    const ShapedLeg next = driven(course.legs[i + 1], window);
    if (turn.half > 0) append_turn(robot_, leg, next, turn, pieces_);
    if (i == first) behind = pieces_.size();
    leg = next;
    into = turn.half;
  }
  lay(leg, into, std::nullopt, average);
  if (pieces_.empty()) return 0;
  plan_.begin(square);
  for (const Piece& piece : pieces_) plan_.add(piece);
  plan_.end_at_rest();
  plan_.plan(average);
  const double time = plan_.time();
  square_after_ = plan_.square(behind);
  return time;
}

/// A motion that begins at a reference begins a whole number of periods later; so does what follows
/// it.
double Rehearsal::settled(double guided, double average) const noexcept {
  const double period = robot_.reference_period;
  return std::ceil(guided / period - 1e-6) * period + average;
}

/// Shorter and shorter means, until two in a row have not helped: where the period is long one
/// often takes as many periods as the one before.
Rehearsal::Best Rehearsal::run(const Course& course, std::size_t first, std::size_t last) {
  const double window = course.legs[first].segment.ahead.window;
  Best best{1, Piece::kAny};
  int idle = 0;
  for (double share = 1; share > kLeast && idle < 2; share *= kLess) {
    const double average = mean_time(share * window);
    const double time = settled(guided(course, first, last, share * window), average);
    idle = time < best.time ? 0 : idle + 1;
    if (idle == 0) best = {share, time};
  }
  return best;
}

Rehearsal::Seen& Rehearsal::seen(const ShapedLeg& leg) {
  constexpr std::size_t kMost = 16;  // [choice] twice as many as are looked at
  const std::uint32_t number = leg.segment.number;
  const auto found = std::ranges::find_if(seen_, [&](const Seen& seen) {
    return seen.number == number && seen.length == leg.length();  // of a motion there may be parts
  });
  if (found != seen_.end()) return *found;
  if (seen_.size() == kMost) seen_.erase(seen_.begin());
  return seen_.emplace_back(Seen{number, leg.length(), {}, {}});
}

std::optional<Turn> Rehearsal::turn(const ShapedLeg& in, const ShapedLeg& out, double longest) {
  std::optional<Turn>& known = seen(in).turn;
  if (!known || known->half > longest) known = make_turn(robot_, in, out, {longest, 0, true});
  return known;
}

Rehearsal::Best Rehearsal::alone(const ShapedLeg& leg) {
  std::optional<Best>& known = seen(leg).alone;
  if (!known) known = tried_alone(leg);
  return *known;
}

/// A leg that takes so many times the mean's time is not tried out: what another mean could save is
/// a fraction of that time. [choice] less than a hundredth of the leg's
constexpr double kLongLeg = 40;

Rehearsal::Best Rehearsal::tried_alone(const ShapedLeg& leg) {
  const double least = leg.length() / greatest_rate(robot_, leg, leg.at(leg.length() / 2));
  const bool is_long = least > kLongLeg * mean_time(leg.segment.ahead.window);
  if (leg.motion.path == nullptr || is_long) {
    const LegAlone made = motion::alone(robot_, leg);
    return {made.share, settled(made.time - made.average, mean_time(made.average))};
  }
  Course course;
  course.legs.push_back(leg);
  return run(course, 0, 0);
}

double Rehearsal::each_alone(const Course& course, std::size_t first) {
  double time = 0;
  for (std::size_t i = first; i < course.legs.size(); ++i) {
    time += alone(course.legs[i]).time;
    if (i > first) time -= won_by_overlap(robot_, course.legs[i - 1], course.legs[i]);
  }
  return time;
}

/// The legs from there on, from rest: alone, or together.
double Rehearsal::any(const Course& course, std::size_t first) {
  const std::size_t count = course.legs.size();
  const double least = each_alone(course, first);
  if (first + 1 >= count) return least;
  return std::min(least, run(course, first, count - 1).time);
}

Rehearsal::Beginning Rehearsal::beginning(const Course& course) {
  const std::size_t count = course.legs.size();
  const Best first = alone(course.legs[0]);
  if (count == 1) return {course.whole, course.whole ? first.share : 1};
  const double stands = std::min(each_alone(course, 0), first.time + any(course, 1));
  Best best = run(course, 0, count - 1);
  if (count == 3) {
    Best two = run(course, 0, 1);
    two.time += alone(course.legs[2]).time;
    if (two.time < best.time) best = two;
  }
  if (stands <= best.time) return {true, first.share};
  return {false, best.share};
}

bool Rehearsal::pays(const Course& course, double window) {
  const std::size_t count = course.legs.size();
  const double average = mean_time(window);
  const auto takes = [&](std::size_t last) {
    const double guide = guided(course, 0, last, window);
    return course.taken ? guide + average : settled(guide, average);
  };
  // With many short legs the mean of this run is as good for another.
  const auto others = [&] {
    if (count <= 3) return any(course, 1);
    return std::min(each_alone(course, 1), settled(guided(course, 1, count - 1, window), average));
  };
  const double stops = takes(0) + others();
  double goes = Piece::kAny;
  if (count == 3) goes = takes(1) + alone(course.legs[2]).time;
  goes = std::min(goes, takes(count - 1));
  return goes <= stops;
}

}  // namespace rob::motion
