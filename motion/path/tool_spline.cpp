#include "motion/path/tool_spline.h"

#include <algorithm>
#include <cmath>

#include "base/unit_factors.h"
#include "motion/path/tool_line.h"
#include "motion/space/rotation.h"

namespace rob::motion {

namespace {

/// The rotation vector, among those of one orientation that are whole turns apart, nearest to
/// `near`.
Eigen::Vector3d nearest_vector(const Eigen::Vector3d& vector, const Eigen::Vector3d& near) {
  constexpr double kNoDirection = 1e-9;  // rad
  const double angle = vector.norm();
  const Eigen::Vector3d direction =
      angle > kNoDirection ? Eigen::Vector3d(vector / angle) : Eigen::Vector3d(near.normalized());
  const double turns = std::round((near.dot(direction) - angle) / kFullTurn);
  return direction * (angle + turns * kFullTurn);
}

}  // namespace

std::optional<ToolSpline> ToolSpline::through(const std::vector<Pose>& points) {
  constexpr double kSame = 1e-9;
  ToolSpline spline;
  spline.first_ = points.front().orientation;
  Eigen::Vector3d turned = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    double knot = 0;
    if (i > 0) {
      const auto line = ToolLine::between(points[i - 1], points[i]);
      if (!line || measure_of(*line) <= kSame) return std::nullopt;
      knot = spline.knots_.back() + measure_of(*line);
      turned = nearest_vector(rotation_between(spline.first_, points[i].orientation), turned);
    }
    spline.knots_.push_back(knot);
    Value value;
    value << points[i].position, turned;
    spline.values_.push_back(value);
  }
  const double whole = spline.knots_.back();
  for (double& knot : spline.knots_) knot /= whole;
  for (std::size_t i = 1; i < points.size(); ++i)
    spline.shortest_ = std::min(spline.shortest_, spline.knots_[i] - spline.knots_[i - 1]);
  spline.bend();
  spline.measure();
  return spline;
}

/// The second derivatives M from  h₋·M₋ + 2(h₋ + h₊)·M + h₊·M₊ = 6·(slope₊ − slope₋), 0 at the
/// ends, eliminated from front to back.
void ToolSpline::bend() {
  const std::size_t n = values_.size();
  bends_.assign(n, Value::Zero());
  std::vector<double> upper(n, 0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double before = knots_[i] - knots_[i - 1];
    const double behind = knots_[i + 1] - knots_[i];
    const Value right =
        6 * ((values_[i + 1] - values_[i]) / behind - (values_[i] - values_[i - 1]) / before);
    const double pivot = 2 * (before + behind) - before * upper[i - 1];
    upper[i] = behind / pivot;
    bends_[i] = (right - before * bends_[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) bends_[i] -= upper[i] * bends_[i + 1];
}

Pose ToolSpline::at(double s) const noexcept {
  const auto behind = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, s);
  const auto i = static_cast<std::size_t>(behind - knots_.begin()) - 1;
  const double h = knots_[i + 1] - knots_[i];
  const double b = (s - knots_[i]) / h;
  const double a = 1 - b;
  const Value value = a * values_[i] + b * values_[i + 1] +
                      ((a * a * a - a) * bends_[i] + (b * b * b - b) * bends_[i + 1]) * (h * h / 6);
  return {value.head<3>(), rotation_by(value.tail<3>()) * first_};
}

void ToolSpline::measure() {
  // [choice] 256 between two points, and 16 in the shortest span: the chords of a span that bends
  // by 90° are short of it by 2e-6 of their length with 256, by 4e-4 with 16.
  constexpr double kMostParts = 16384;
  const double even = 256 * static_cast<double>(knots_.size() - 1);
  const auto parts =
      static_cast<std::size_t>(std::clamp(16 / shortest_, std::min(even, kMostParts), kMostParts));
  const double step = 1 / static_cast<double>(parts);
  lengths_ = {0};
  Pose before = at(0);
  for (std::size_t i = 1; i <= parts; ++i) {
    const Pose pose = at(static_cast<double>(i) * step);
    const double way = (pose.position - before.position).norm();
    const double turn = rotation_between(before.orientation, pose.orientation).norm();
    lengths_.push_back(lengths_.back() + way);
    turn_ += turn;
    greatest_speed_ = std::max(greatest_speed_, way / step);
    greatest_turning_ = std::max(greatest_turning_, turn / step);
    before = pose;
  }
}

double ToolSpline::share_at(double s) const noexcept {
  const double place = std::clamp(s, 0.0, 1.0) * static_cast<double>(lengths_.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(place), lengths_.size() - 2);
  const double within = place - static_cast<double>(i);
  if (!(way() > 0)) return s;
  return (lengths_[i] + within * (lengths_[i + 1] - lengths_[i])) / way();
}

double ToolSpline::at_share(double share) const noexcept { return parameter_of(*this, share); }

}  // namespace rob::motion
