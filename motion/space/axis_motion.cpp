#include "motion/space/axis_motion.h"

#include <algorithm>
#include <cmath>

namespace rob::motion {

namespace {

/// Relative: a stop at once that ends so near to the target ends there. [choice] What rounding
/// leaves of it is less; to go back for it would take its cube root.
constexpr double kSamePlace = 1e-13;

/// Relative: of an instant that Newton's method moves no further. [choice] Two roundings.
constexpr double kExact = 2e-16;

enum class Goal { Place, Time };

/// A course that has been followed up to a state and stops from there, the beginning at 0.
struct Leaving {
  SpeedChange stop;
  double place = 0;  ///< of its end
  double time = 0;   ///< of its end

  double value(Goal goal) const noexcept { return goal == Goal::Place ? place : time; }
};

Leaving leave(const AxisState& state, double time, const AxisLimits& limits) noexcept {
  const SpeedChange stop = speed_change(state, 0, limits);
  return {stop, stop.end(state).q, time + stop.duration()};
}

/// How the end changes with the instant of leaving, while the jerk is `jerk`: where a phase of
/// jerk j1 gives way to one of j2, s before the end, a delay of δ adds (j1 − j2)·δ to the
/// acceleration at the end, s times that to the speed and s²/2 times that to the place. The later
/// changes of the stop move so that acceleration and speed stay 0.
double slope(Goal goal, const Leaving& leaving, double jerk, const AxisLimits& limits) noexcept {
  const auto& [first, hold, last] = leaving.stop.phases;
  if (std::isinf(limits.j)) {
    if (hold.acceleration > 0) return 0;
    return goal == Goal::Place ? 2 * limits.a * hold.duration : 2;
  }
  if (first.jerk > 0) return 0;  // to stop is to go on
  const double of_switch = (jerk + limits.j) / (2 * limits.j);
  if (goal == Goal::Time) return 2 * of_switch * first.duration / last.duration;
  return of_switch * limits.j * first.duration *
         (first.duration + 2 * hold.duration + last.duration);
}

/// When to leave a phase, for the end to be at `goal`, which lies between the ends of leaving it at
/// once and at its end.
double time_to_leave(Goal goal, double aim, const AxisState& begin, double begun,
                     const JerkPhase& phase, const AxisLimits& limits, double guess) noexcept {
  double low = 0;
  double high = phase.duration;
  double t = guess;
  for (int i = 0; i < AxisMotion::kMostSteps; ++i) {
    const Leaving leaving = leave(phase.after(begin, t), begun + t, limits);
    const double beyond = leaving.value(goal) - aim;
    if (beyond == 0) return t;
    (beyond < 0 ? low : high) = t;
    const double step = beyond / slope(goal, leaving, phase.jerk, limits);
    if (std::abs(step) <= kExact * high) return t;
    double next = t - step;
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (next == low || next == high) return next;
    t = next;
  }
  return t;
}

/// From a state at place 0 towards v_max, leaving for the stop that ends at the goal: a place
/// beyond that of the stop at once, or a time no less than its.
AxisCourse course_to(Goal goal, double aim, const AxisState& from,
                     const AxisLimits& limits) noexcept {
  AxisCourse course;
  course.begin = from;
  AxisState state = from;
  double time = 0;
  double before = leave(state, 0, limits).value(goal);
  const auto finish = [&](const AxisState& last) noexcept {
    for (const JerkPhase& phase : speed_change(last, 0, limits).phases) {
      course.append(phase, phase.duration);
    }
    return course;
  };
  for (const JerkPhase& phase : speed_change(from, limits.v, limits).phases) {
    const AxisState end = phase.after(state, phase.duration);
    const double after = leave(end, time + phase.duration, limits).value(goal);
    if (aim <= after && phase.duration > 0) {
      // From rest the place grows with the third power of the time, the time as the time.
      const double share = std::clamp((aim - before) / (after - before), 0.0, 1.0);
      const double guess = phase.duration * (goal == Goal::Place ? std::cbrt(share) : share);
      const double t = time_to_leave(goal, aim, state, time, phase, limits, guess);
      course.append(phase, t);
      return finish(phase.after(state, t));
    }
    course.append(phase, phase.duration);
    time += phase.duration;
    state = end;
    before = after;
  }
  const double cruise = (aim - before) / (goal == Goal::Place ? limits.v : 1);
  course.append({}, cruise);
  return finish({state.q, limits.v, 0});
}

AxisState mirrored(const AxisState& state, double side) noexcept {
  return {0, side * state.v, side * state.a};
}

}  // namespace

void AxisCourse::append(const JerkPhase& phase, double duration) noexcept {
  if (!(duration > 0)) return;
  phases[static_cast<std::size_t>(count++)] = {duration, phase.acceleration, phase.jerk};
}

double AxisCourse::duration() const noexcept {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += phases[static_cast<std::size_t>(i)].duration;
  return sum;
}

AxisState AxisCourse::at(double t) const noexcept {
  AxisState state = begin;
  for (int i = 0; i < count; ++i) {
    const JerkPhase& phase = phases[static_cast<std::size_t>(i)];
    if (t <= phase.duration) return phase.after(state, t);
    state = phase.after(state, phase.duration);
    t -= phase.duration;
  }
  return {state.q, 0, 0};
}

AxisMotion::AxisMotion(const AxisState& from, double target, const AxisLimits& limits) noexcept
    : limits_(limits), begin_(from.q), way_(target - from.q), target_(target) {
  stop_.begin = {0, from.v, from.a};
  const SpeedChange stop = speed_change(stop_.begin, 0, limits);
  for (const JerkPhase& phase : stop.phases) stop_.append(phase, phase.duration);
  duration_ = stop.duration();
  const double left = way_ - stop.end(stop_.begin).q;
  side_ = left < 0 ? -1 : 1;
  if (std::abs(left) <= kSamePlace * (std::abs(way_) + std::abs(from.v) * duration_)) return;
  far_ = course_to(Goal::Place, side_ * way_, mirrored(stop_.begin, side_), limits);
  share_ = 1;
  duration_ = far_.duration();
}

void AxisMotion::stretch(double time) noexcept {
  if (!(time > duration_)) return;
  duration_ = time;
  if (share_ == 0) return;  // it stops there at once, and waits
  far_ = course_to(Goal::Time, time, mirrored(stop_.begin, side_), limits_);
  const double near = side_ * stop_.at(time).q;
  const double gained = far_.at(time).q - near;
  share_ = gained > 0 ? std::clamp((side_ * way_ - near) / gained, 0.0, 1.0) : 1;
}

AxisState AxisMotion::at(double t) const noexcept {
  if (t >= duration_) return {target_, 0, 0};
  const AxisState stop = share_ < 1 ? stop_.at(t) : AxisState{};
  const AxisState far = share_ > 0 ? far_.at(t) : AxisState{};
  const double of_stop = 1 - share_;
  const double of_far = side_ * share_;
  return {begin_ + of_stop * stop.q + of_far * far.q, of_stop * stop.v + of_far * far.v,
          of_stop * stop.a + of_far * far.a};
}

}  // namespace rob::motion
