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
    : robot_(std::move(robot)), start_(start), last_target_(start), last_t_acc_(robot_.t_acc) {
  for (const PaulStep& step : steps) {
    if (step.stop) {
      stop(step.line, false);
      continue;
    }
    move(step);
    if (step.zone.kind == PaulZone::Kind::Fine) stop(step.line, true);
  }
}

void PaulModel::move(const PaulStep& step) {
  double t1 = step.t_user;
  for (std::size_t i = 0; i < start_.size(); ++i) {
    t1 = std::max(t1, std::abs(step.target[i] - last_target_[i]) / robot_.v_max[i]);
  }
  const double distance = tool_distance(step.target, last_target_, robot_.tool_axes);
  const double t_out = zone_t_acc(step.zone, distance, t1);
  exact_ = step.target == last_target_;
  add({.line = step.line,
       .t1 = std::max(t1, last_t_acc_ + t_out),
       .t_out = t_out,
       .a = {},
       .b = {},
       .c = step.target});
}

/// The target once more, with its own t_acc on both sides.
void PaulModel::stop(int line, bool further) {
  if (!exact_) {
    add({.line = line,
         .stop = true,
         .further = further,
         .t1 = 2 * last_t_acc_,
         .t_out = last_t_acc_,
         .a = {},
         .b = {},
         .c = last_target_});
  }
  exact_ = true;
}

/// t_acc at the target. For a length z it is the greatest for which 3/16·t_acc·(v_in + v_max) <= z,
/// v_in being the tool's speed distance/T1, which itself depends on t_acc where the corners decide:
/// looked for by bisection.
double PaulModel::zone_t_acc(const PaulZone& zone, double distance, double t1) const {
  if (zone.kind == PaulZone::Kind::Time) return zone.value;
  if (zone.kind == PaulZone::Kind::Share) return zone.value * robot_.t_acc;
  if (zone.kind != PaulZone::Kind::Length) return robot_.t_acc;
  double squares = 0;
  for (std::size_t i = 0; i < robot_.tool_axes; ++i) squares += robot_.v_max[i] * robot_.v_max[i];
  double low = 0;
  double high = robot_.t_acc;
  for (int i = 0; i < 80; ++i) {
    const double t = (low + high) / 2;
    const double v_in = distance / std::max(t1, last_t_acc_ + t);
    (3 * t * (v_in + std::sqrt(squares)) / 16 <= zone.value ? low : high) = t;
  }
  return low;
}

// A := present reference X, B := C, C := the new target; t begins at −t_acc (S1).
void PaulModel::add(PaulSegment next) {
  next.a = start_;
  next.b = start_;
  next.t_in = last_t_acc_;
  if (!segments_.empty()) {
    const PaulSegment& last = segments_.back();
    next.start = last.start + last.span();
    next.a = in_segment(last, last.t1 - last.t_out).q;
    next.b = last.c;
  }
  last_target_ = next.c;
  last_t_acc_ = next.t_out;
  segments_.push_back(std::move(next));
}

double PaulModel::least_t_acc() const {
  double least = robot_.t_acc;
  for (const PaulSegment& segment : segments_) least = std::min(least, segment.t_out);
  return least;
}

double PaulModel::total() const {
  return segments_.empty() ? 0 : segments_.back().start + segments_.back().span();
}

AxisState PaulModel::at(double time) const {
  if (segments_.empty() || time < 0) {
    const AxisValues rest(start_.size(), 0.0);
    return {start_, rest, rest};
  }
  if (time >= total()) {
    const AxisValues rest(start_.size(), 0.0);
    const PaulSegment& last = segments_.back();
    return {in_segment(last, last.t1 - last.t_out).q, rest, rest};
  }
  const auto after = std::upper_bound(segments_.begin(), segments_.end(), time,
                                      [](double t, const PaulSegment& s) { return t < s.start; });
  const PaulSegment& segment = *(after - 1);
  return in_segment(segment, time - segment.start - segment.t_in);
}

// The formulas of S1, letter by letter; t = 0 is the instant at which B would be reached.
AxisState PaulModel::in_segment(const PaulSegment& segment, double t) const {
  const double t_acc = segment.t_in;
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
  const double decision = passed.start + passed.span();
  return least_distance(passed.c, decision, decision + 2 * passed.t_out);
}

double PaulModel::nearest_pass(std::size_t segment) const {
  const PaulSegment& passed = segments_[segment];
  const double decision = passed.start + passed.span();
  const double end =
      segment + 1 < segments_.size() ? decision + segments_[segment + 1].span() : total();
  return std::min({corner_miss(segment), least_distance(passed.c, passed.start, decision),
                   least_distance(passed.c, decision, end)});
}

}  // namespace rob::test
