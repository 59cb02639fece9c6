#include "tests/support/paul_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rob::test {

double tool_distance(const AxisValues& p, const AxisValues& q, std::size_t tool_axes) {
  double sum = 0;
  for (std::size_t i = 0; i < tool_axes; ++i) sum += (p[i] - q[i]) * (p[i] - q[i]);
  return std::sqrt(sum);
}

PaulModel::PaulModel(PaulRobot robot, const AxisValues& start, const std::vector<PaulStep>& steps)
    : robot_(std::move(robot)), start_(start) {
  AxisValues last_target = start;
  bool exact = true;  // nothing has moved, or the last segment had no length
  for (const PaulStep& step : steps) {
    if (step.stop) {
      if (!exact) add(step, last_target, 2 * robot_.t_acc);
      exact = true;
      continue;
    }
    double t1 = std::max(2 * robot_.t_acc, step.t_user);
    for (std::size_t i = 0; i < start.size(); ++i) {
      t1 = std::max(t1, std::abs(step.target[i] - last_target[i]) / robot_.v_max[i]);
    }
    exact = step.target == last_target;
    add(step, step.target, t1);
    last_target = step.target;
  }
}

// A := present reference X, B := C, C := the new target; t begins at −t_acc (S1).
void PaulModel::add(const PaulStep& step, const AxisValues& target, double t1) {
  PaulSegment next{.line = step.line,
                   .stop = step.stop,
                   .start = 0,
                   .t1 = t1,
                   .a = start_,
                   .b = start_,
                   .c = target};
  if (!segments_.empty()) {
    const PaulSegment& last = segments_.back();
    next.start = last.start + last.t1;
    next.a = in_segment(last, last.t1 - robot_.t_acc).q;
    next.b = last.c;
  }
  segments_.push_back(std::move(next));
}

double PaulModel::total() const {
  return segments_.empty() ? 0 : segments_.back().start + segments_.back().t1;
}

AxisState PaulModel::at(double time) const {
  if (segments_.empty() || time < 0) {
    const AxisValues rest(start_.size(), 0.0);
    return {start_, rest, rest};
  }
  if (time >= total()) {
    const AxisValues rest(start_.size(), 0.0);
    const PaulSegment& last = segments_.back();
    return {in_segment(last, last.t1 - robot_.t_acc).q, rest, rest};
  }
  const auto after = std::upper_bound(segments_.begin(), segments_.end(), time,
                                      [](double t, const PaulSegment& s) { return t < s.start; });
  const PaulSegment& segment = *(after - 1);
  return in_segment(segment, time - segment.start - robot_.t_acc);
}

// The formulas of S1, letter by letter; t = 0 is the instant at which B would be reached.
AxisState PaulModel::in_segment(const PaulSegment& segment, double t) const {
  const double t_acc = robot_.t_acc;
  const std::size_t axes = start_.size();
  AxisState state{AxisValues(axes), AxisValues(axes), AxisValues(axes)};
  for (std::size_t i = 0; i < axes; ++i) {
    const double b = segment.b[i];
    const double delta_c = segment.c[i] - b;
    const double delta_b = segment.a[i] - b;
    if (t > t_acc) {
      state.q[i] = b + delta_c * t / segment.t1;
      state.qd[i] = delta_c / segment.t1;
      state.qdd[i] = 0;
      continue;
    }
    const double h = (t + t_acc) / (2 * t_acc);
    const double bend = delta_c * t_acc / segment.t1 + delta_b;
    state.q[i] = (bend * (2 - h) * h * h - 2 * delta_b) * h + b + delta_b;
    state.qd[i] = (bend * (1.5 - h) * 2 * h * h - delta_b) / t_acc;
    state.qdd[i] = bend * (1 - h) * 3 * h / (t_acc * t_acc);
  }
  return state;
}

double PaulModel::least_distance(const AxisValues& place, double from, double to) const {
  constexpr int kPlaces = 4000;
  double least = tool_distance(at(from).q, place, robot_.tool_axes);
  for (int k = 1; k <= kPlaces; ++k) {
    const double time = from + (to - from) * k / kPlaces;
    least = std::min(least, tool_distance(at(time).q, place, robot_.tool_axes));
  }
  return least;
}

double PaulModel::corner_miss(std::size_t segment) const {
  const PaulSegment& passed = segments_[segment];
  const double decision = passed.start + passed.t1;
  return least_distance(passed.c, decision, decision + 2 * robot_.t_acc);
}

double PaulModel::nearest_pass(std::size_t segment) const {
  const PaulSegment& passed = segments_[segment];
  const double decision = passed.start + passed.t1;
  const double end =
      segment + 1 < segments_.size() ? decision + segments_[segment + 1].t1 : total();
  return std::min({corner_miss(segment), least_distance(passed.c, passed.start, decision),
                   least_distance(passed.c, decision, end)});
}

}  // namespace rob::test
