#include "motion/path/paced_path.h"

#include <algorithm>

namespace rob::motion {

PaceLaw::PaceLaw(const std::vector<Place>& places, double average) {
  points_.reserve(places.size());
  points_.push_back({0, places.front().s, places.front().rate, 0});
  for (std::size_t k = 1; k < places.size(); ++k) {
    const Instant& last = points_.back();
    const Place& place = places[k];
    const double time = 2 * (place.s - last.s) / (last.rate + place.rate);
    const double change = place.rate - last.rate;
    const double sum = time * (last.s + time * (last.rate / 2 + change / 6));
    points_.push_back({last.time + time, place.s, place.rate, last.sum + sum});
  }
  average_ = std::min(average, duration());
  for (const Instant& point : points_) greatest_ = std::max(greatest_, at(point.time).rate);
}

/// s, s' and the sum at any time; beyond an end mirrored about it.
PaceLaw::Instant PaceLaw::without_mean(double time) const noexcept {
  const Instant& end = points_.back();
  if (time < 0) {
    const Instant mirrored = without_mean(-time);
    return {time, -mirrored.s, mirrored.rate, mirrored.sum};
  }
  if (time > end.time) {
    const Instant mirrored = without_mean(2 * end.time - time);
    return {time, 2 * end.s - mirrored.s, mirrored.rate,
            mirrored.sum + 2 * end.s * (time - end.time)};
  }
  const auto later = [](double t, const Instant& point) { return t < point.time; };
  const auto after = std::upper_bound(points_.begin() + 1, points_.end() - 1, time, later);
  const Instant& from = *(after - 1);
  const double whole = after->time - from.time;
  const double h = time - from.time;
  const double bend = whole > 0 ? (after->rate - from.rate) / whole : 0;
  return {time, from.s + h * (from.rate + h * bend / 2), from.rate + h * bend,
          from.sum + h * (from.s + h * (from.rate / 2 + h * bend / 6))};
}

PaceLaw::Point PaceLaw::at(double time) const noexcept {
  const Instant before = without_mean(time - average_ / 2);
  const Instant after = without_mean(time + average_ / 2);
  return {(after.sum - before.sum) / average_, (after.s - before.s) / average_,
          (after.rate - before.rate) / average_};
}

double PaceLaw::time_at(double s) const noexcept {
  double low = 0;
  double high = duration();
  for (int i = 0; i < 60; ++i) {  // halvings: to the last bit
    const double middle = (low + high) / 2;
    (at(middle).s < s ? low : high) = middle;
  }
  return high;
}

double PacedPath::inner(double s) const noexcept {
  return path_.begin() + law_.at(s * law_.duration()).s * span();
}

double PacedPath::outer(double s) const noexcept {
  const double share = (s - path_.begin()) / span();
  return share <= 0 ? 0 : share >= 1 ? 1 : law_.time_at(share) / law_.duration();
}

/// [choice] At least two nodes for each node of the axes, and one for each mean's time; eight where
/// the rate changes by more than a twentieth within that time.
JointPath PacedPath::paced(const JointPath& axes) const {
  constexpr double kEven = 0.05;
  std::vector<JointPath::Node> nodes;
  const double total = law_.duration();
  const double scale = total * span();
  const auto add = [&](double time) {
    const PaceLaw::Point pace = law_.at(time);
    const PathPoint point = axes.at(path_.begin() + pace.s * span());
    const double rate = pace.rate * scale;
    nodes.push_back({time / total, point.q, point.qd * rate,
                     point.qdd * (rate * rate) + point.qd * (pace.acceleration * total * scale)});
  };
  double time = 0;
  for (std::size_t i = 1; i < axes.nodes().size(); ++i) {
    const double share = (axes.nodes()[i].time - path_.begin()) / span();
    const double until = i + 1 == axes.nodes().size() ? total : law_.time_at(share);
    const double most = (until - time) / 2;
    while (until - time > 1e-9 * total) {
      add(time);
      const PaceLaw::Point pace = law_.at(time);
      const PaceLaw::Point next = law_.at(std::min(time + law_.average(), total));
      const bool even = std::abs(next.rate - pace.rate) < kEven * pace.rate;
      const double step = std::min(most, law_.average() / (even ? 1 : 8));
      time = until - time < 1.5 * step ? until : time + step;
    }
  }
  add(total);
  return JointPath(std::move(nodes));
}

}  // namespace rob::motion
