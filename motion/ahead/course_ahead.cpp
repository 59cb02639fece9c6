#include "motion/ahead/course_ahead.h"

#include <algorithm>
#include <utility>

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

void CourseAhead::begin_run() {
  into_.reset();
  entry_ = 0;
}

void CourseAhead::enter(double taken) {
  into_ = taken;
  entry_ = rehearsal_.square_after();
}

std::optional<Turn> CourseAhead::corner(const ShapedLeg& in, const ShapedLeg& out, std::size_t at,
                                        double window, bool from_rest) const {
  const bool whole_run =
      from_rest && (intake_.at(at + 1) != nullptr ? !goes_on_behind(out, at, window)
                                                  : ends_at_rest(out.segment, at));
  TurnBounds bounds{std::min(in.length() - in.sent, share_of(out, at)),
                    whole_periods(robot_, window), robot_.tool_coordinates, from_rest, whole_run};
  std::optional<Turn> made = make_turn(robot_, in, out, bounds);
  if (made || robot_.tool_coordinates || !goes_on_behind(out, at, window)) return made;
  bounds.to_rest = false;
  return make_turn(robot_, in, out, bounds);
}

/// Whether the leg has another corner at its end, which is faster than a stop.
bool CourseAhead::goes_on_behind(const ShapedLeg& leg, std::size_t at, double window) const {
  const PathItem* const item = intake_.at(at + 1);
  if (item == nullptr || !has_way(item->segment) || item->segment.from_rest) return false;
  const ShapedLeg behind = shape(*item, leg.end());
  return make_turn(robot_, leg, behind,
                   {std::min(leg.length(), behind.length()) / 2, whole_periods(robot_, window),
                    false, true})
      .has_value();
}

bool CourseAhead::ends_at_rest(const SegmentDescriptor& segment, std::size_t at) const {
  if (segment.guard.present()) return true;
  const PathItem* const behind = intake_.at(at + 1);
  if (behind == nullptr) return intake_.nothing_comes();
  return !moves(behind->segment) || behind->segment.from_rest;
}

/// m of the leg that the corner into it may take: those that the corner out of it leaves, or half.
double CourseAhead::share_of(const ShapedLeg& leg, std::size_t at) const {
  const double length = leg.length();
  if (ends_at_rest(leg.segment, at)) return length;  // there is no corner
  const PathItem* const behind = intake_.at(at + 1);
  if (behind == nullptr || !has_way(behind->segment)) return length / 2;
  const double other = wanted_half(robot_, leg, shape(*behind, leg.end()));
  return std::max(length / 2, length - other);
}

bool CourseAhead::stands_after(const ShapedLeg& leg, std::size_t next, double window) const {
  if (leg.segment.guard.present()) return true;
  const PathItem* const item = intake_.at(next);
  if (item == nullptr) return intake_.nothing_comes();
  if (!moves(item->segment) || item->segment.from_rest) return true;
  if (!has_way(item->segment) || leg.motion.path != nullptr || leg.stretch) return false;
  return !corner(leg, shape(*item, leg.end()), next, window, true);
}

/// The same. On an arm a rehearsal compares the stop with a corner.
bool CourseAhead::stands_alone(const ShapedLeg& leg, std::size_t next, double window) {
  if (!averages_sigma(window)) return stands_after(leg, next, window);
  return beginning(leg, next, window).stands;
}

std::optional<ShapedLeg> CourseAhead::next_alone(const ShapedLeg& leg) {
  const PathItem* const item = intake_.at(0);
  if (item == nullptr || leg.segment.guard.present()) return std::nullopt;
  const SegmentDescriptor& next = item->segment;
  if (!has_way(next) || next.from_rest || next.path != nullptr || item->stretch ||
      next.generation <= ring_.over() || next.guard.present() || next.live.present())
    return std::nullopt;
  ShapedLeg shaped = shape(*item, leg.end());
  const bool stands = stands_alone(shaped, 1, next.ahead.window);  // as if it began a run
  return stands ? std::optional(std::move(shaped)) : std::nullopt;
}

/// The legs after this one without a stop, and their corners as far as they can be foretold.
Course CourseAhead::course_from(const ShapedLeg& leg, std::size_t next, double window) {
  Course course;
  course.legs.push_back(shape({leg.segment, leg.stretch}, leg.begin));
  course.taken = into_;
  course.square = entry_;
  double time = least_time(robot_, leg);
  const std::size_t most = leg.goes_on() ? PathIntake::kMostParts : PathIntake::kMostLegs;
  while (!course.whole && course.legs.size() < most) {
    const std::size_t count = course.legs.size();
    if (count >= kLegs && time > kMeans * whole_periods(robot_, window)) return course;
    const PathItem* const item = intake_.at(next + count - 1);
    if (course.legs.back().segment.guard.present() ||
        (item == nullptr && intake_.nothing_comes())) {
      course.whole = true;
      return course;
    }
    if (item == nullptr) return course;
    const SegmentDescriptor& segment = item->segment;
    if ((moves(segment) && !has_way(segment)) || segment.generation <= ring_.over()) return course;
    const bool last = intake_.at(next + count) == nullptr;
    if (!has_way(segment) || segment.from_rest || !extend(course, *item, last)) course.whole = true;
    time += least_time(robot_, course.legs.back());
  }
  return course;
}

/// By a leg, and the corner into it; false where only a stop leads to it. `last`: no more items are
/// known.
bool CourseAhead::extend(Course& course, const PathItem& item, bool last) {
  const ShapedLeg& before = course.legs.back();
  const ShapedLeg leg = shape(item, before.end());
  const double taken = course.turns.empty() ? course.taken.value_or(0) : course.turns.back().half;
  const bool ends = last && intake_.nothing_comes();
  const double longest = std::min(before.length() - taken, ends ? leg.length() : leg.length() / 2);
  std::optional<Turn> turn = rehearsal_.turn(before, leg, longest);
  if (!turn) return false;
  course.turns.push_back(std::move(*turn));
  course.legs.push_back(leg);
  return true;
}

bool CourseAhead::pays(const ShapedLeg& leg, const Turn& turn, double window) {
  Course course = course_from(leg, 0, window);
  if (course.turns.empty()) return false;
  course.turns[0] = turn;
  return rehearsal_.pays(course, window);
}

bool CourseAhead::sooner_apart(std::size_t items, const std::vector<PathItem>& legs, double sigma) {
  Course course;
  for (std::size_t i = 0; i < items; ++i)
    course.legs.push_back(shape(*intake_.at(i), i == 0 ? sigma : course.legs.back().end()));
  course.turns.resize(items - 1);
  double left = rehearsal_.together(course);
  for (const PathItem& leg : legs)
    if (left > 0 && has_way(leg.segment)) left -= rehearsal_.apart(shape(leg, sigma));
  return left > 0;
}

}  // namespace rob::motion
