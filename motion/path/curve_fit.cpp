#include "motion/path/curve_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "motion/path/banded_system.h"

namespace rob::motion {

namespace {

using Eigen::Vector3d;

constexpr std::size_t kCubic = 3;
/// [choice] Found on reliefs, circles, noisy lines and random polylines: more of any costs time and
/// gains less than a part in a thousand.
constexpr double kDatumsApart = 0.25;     // u between two places that the curve has to pass
constexpr double kAimed = 0.87;           // part of the tolerance at which the weights aim
constexpr double kMost = 0.94;            // part that is never exceeded; the rest is for chords
constexpr double kChord = 0.05;           // part that a chord may leave out
constexpr std::size_t kMostInChord = 64;  // vertices: a bound on the time that finding one takes
constexpr int kRounds = 6;                // in the last three of which weights only grow
constexpr int kGrowing = 3;
constexpr int kExtraRounds = 60;
constexpr int kMostDoublings = 12;  // of one part, so that a curve has an end
constexpr double kLeastWeight = 1e-9;
constexpr double kMostWeight = 1e6;
constexpr double kExactWeight = 1e7;
constexpr double kKnotsOfStraight = 3;
constexpr double kLeastWindow = 24;  // controls, times the stiffness
constexpr double kMostWindow = 64;

using Basis = std::array<double, kCubic + 1>;

/// The uniform cubic B-splines of a span, at t = 0 … 1 of it.
Basis basis(double t) {
  const double s = 1 - t;
  return {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
          (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6, t * t * t / 6};
}
Basis basis_slope(double t) {
  const double s = 1 - t;
  return {-s * s / 2, (3 * t * t - 4 * t) / 2, (-3 * t * t + 2 * t + 1) / 2, t * t / 2};
}
Basis basis_bend(double t) { return {1 - t, 3 * t - 2, 1 - 3 * t, t}; }

}  // namespace

CurveFit::CurveFit(double knot, double stiffness, int order)
    : knot_(knot),
      order_(order),
      first_weight_(0.3 * std::pow(std::max(stiffness, 1.0), -2 * order)),
      window_(static_cast<std::size_t>(
          std::clamp(kLeastWindow * stiffness, kLeastWindow, kMostWindow))) {}

void CurveFit::begin(const Vector3d& place) {
  data_.push_back({place, 0, knot_, kExactWeight, true});
  vertices_.push_back(0);
}

void CurveFit::begin_straight(const Vector3d& place, const Vector3d& direction) {
  data_.push_back({place, 0, knot_, kExactWeight, true});
  vertices_.push_back(0);
  for (const double k : {-1.0, 0.0, 1.0}) controls_.push_back(place + k * knot_ * direction);
  frozen_ = controls_.size();
}

/// Whether the chord from the last datum to `next` leads through all that waits, in its order.
bool CurveFit::fits_chord(const Pending& next) const {
  if (chord_.empty()) return true;
  if (chord_.size() >= kMostInChord || chord_.front().dense != next.dense) return false;
  const Vector3d from = data_.back().place;
  const Vector3d way = next.place - from;
  const double square = way.squaredNorm();
  if (square == 0) return false;
  double last = 0;
  for (const Pending& passed : chord_) {
    const double share = (passed.place - from).dot(way) / square;
    if (share < last || share > 1) return false;
    if ((from + share * way - passed.place).norm() > kChord * passed.tolerance) return false;
    last = share;
  }
  return true;
}

void CurveFit::append(const Vector3d& place, double tolerance, double dense) {
  const Pending next{place, tolerance, dense};
  if (!fits_chord(next)) close_chord();
  chord_.push_back(next);
}

/// The vertices that wait lie on the chord to the last of them.
void CurveFit::close_chord() {
  if (chord_.empty()) return;
  const Vector3d from = data_.back().place;
  const Vector3d way = chord_.back().place - from;
  const double square = way.squaredNorm();
  const double span = std::sqrt(square) / knot_ * chord_.front().dense;
  double tolerance = std::numeric_limits<double>::infinity();
  for (const Pending& passed : chord_) {
    const double share = square > 0 ? (passed.place - from).dot(way) / square : 1;
    vertices_.push_back(length_ + span * share);
    tolerance = std::min(tolerance, passed.tolerance);
  }
  const Vector3d to = chord_.back().place;
  chord_.clear();
  if (square > 0) add_data({to, length_ + span, tolerance, 0, false});
}

/// To the place, and between it and the last, on the straight way.
void CurveFit::add_data(const Datum& to) {
  const Datum last = data_.back();
  const double parts = std::max(1.0, std::ceil((to.u - last.u) / kDatumsApart - 1e-9));
  for (double k = 1; k <= parts; ++k) {
    Datum datum = to;
    if (k < parts) {
      datum.place = last.place + (to.place - last.place) * (k / parts);
      datum.u = last.u + (to.u - last.u) * (k / parts);
      datum.exact = false;
      datum.weight = 0;
    }
    data_.push_back(datum);
  }
  length_ = to.u;
}

void CurveFit::end() {
  close_chord();
  data_.back().exact = true;
  data_.back().weight = kExactWeight;
  ended_ = true;
}

double CurveFit::end_straight(const Vector3d& direction) {
  close_chord();
  const Datum last = data_.back();
  const double u = std::ceil(length_ + kKnotsOfStraight);
  const double way = (u - length_) * knot_;
  const Vector3d place = last.place + way * direction;
  add_data({place, u, last.tolerance, 0, false});
  const auto first = static_cast<std::size_t>(std::lround(u));
  controls_.resize(first + kCubic - dropped_, Vector3d::Zero());
  for (const double k : {-1.0, 0.0, 1.0})
    control(first + static_cast<std::size_t>(k + 1)) = place + k * knot_ * direction;
  fixed_end_ = kCubic;
  ended_ = true;
  return way;
}

double CurveFit::at_vertex(std::size_t i) const {
  const std::size_t at = i - dropped_vertices_;
  return at < vertices_.size() ? vertices_[at] : std::numeric_limits<double>::infinity();
}

/// On the nearest of the straight ways between the places of the fit.
double CurveFit::at_place(double from, double to, const Vector3d& place) const {
  double nearest = std::numeric_limits<double>::infinity();
  double found = from;
  for (std::size_t i = 0; i + 1 < data_.size(); ++i) {
    const Datum& a = data_[i];
    const Datum& b = data_[i + 1];
    if (b.u < from || a.u > to) continue;
    const Vector3d way = b.place - a.place;
    const double share = std::clamp((place - a.place).dot(way) / way.squaredNorm(), 0.0, 1.0);
    const double distance = (a.place + share * way - place).norm();
    if (!(distance < nearest)) continue;
    nearest = distance;
    found = a.u + share * (b.u - a.u);
  }
  return std::clamp(found, from, to);
}

/// Controls of a curve as long as what is known.
std::size_t CurveFit::count() const noexcept {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length_ - 1e-9))) + kCubic;
}

std::size_t CurveFit::span_of(double u) const noexcept {
  return std::min(static_cast<std::size_t>(u), count() - kCubic - 1);
}

bool CurveFit::ready() const noexcept {
  if (ended_) return settled_ < length_;
  return length_ >= static_cast<double>(frozen_ + window_ - kCubic);
}

Vector3d CurveFit::curve(double u, std::size_t span) const {
  const Basis b = basis(u - static_cast<double>(span));
  Vector3d sum = Vector3d::Zero();
  for (std::size_t k = 0; k <= kCubic; ++k) sum += b[k] * control(span + k);
  return sum;
}

double CurveFit::missed(const Datum& datum) const {
  return (curve(datum.u, span_of(datum.u)) - datum.place).norm() / datum.tolerance;
}

/// Those that are new share the first weight with all in their span.
void CurveFit::weigh_new(std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < end;) {
    std::size_t last = i;
    while (last < end && span_of(data_[last].u) == span_of(data_[i].u)) ++last;
    const double weight = first_weight_ / static_cast<double>(last - i);
    for (; i < last; ++i)
      if (data_[i].weight == 0) data_[i].weight = weight;
  }
}

/// The controls from frozen_ to `until`, by least squares over these data.
void CurveFit::solve(std::size_t until, std::size_t begin, std::size_t end) {
  BandedSystem system(until - frozen_);
  const auto add_row = [&](std::size_t first, const double* factors, std::size_t size,
                           double weight, const Vector3d& value) {
    Vector3d left = value;  // less what is known
    for (std::size_t k = 0; k < size; ++k)
      if (first + k < frozen_ || first + k >= until) left -= factors[k] * control(first + k);
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t i = first + k;
      if (i < frozen_ || i >= until) continue;
      system.add_right(i - frozen_, weight * factors[k] * left);
      for (std::size_t l = 0; l <= k; ++l)
        if (first + l >= frozen_)
          system.add(i - frozen_, first + l - frozen_, weight * factors[k] * factors[l]);
    }
  };
  constexpr std::array kSecond = {1.0, -2.0, 1.0};
  constexpr std::array kThird = {-1.0, 3.0, -3.0, 1.0};
  const std::size_t all = until + fixed_end_ == count() ? count() : until;
  const auto order = static_cast<std::size_t>(order_);
  for (std::size_t j = frozen_ - std::min(frozen_ - dropped_, order); j + order < all; ++j)
    add_row(j, order_ == 2 ? kSecond.data() : kThird.data(), order + 1, 1, Vector3d::Zero());
  for (std::size_t i = begin; i < end; ++i) {
    const std::size_t span = span_of(data_[i].u);
    const Basis b = basis(data_[i].u - static_cast<double>(span));
    add_row(span, b.data(), b.size(), data_[i].weight, data_[i].place);
  }
  const std::vector<Vector3d>& found = system.solve();
  for (std::size_t i = 0; i < found.size(); ++i) control(frozen_ + i) = found[i];
}

/// Whether one of them is missed by too much.
bool CurveFit::reweigh(std::size_t begin, std::size_t end, int round) {
  bool violated = false;
  for (std::size_t i = begin; i < end; ++i) {
    Datum& datum = data_[i];
    if (datum.exact) continue;
    const double share = missed(datum);
    violated = violated || share > kMost;
    const double ratio = share / kAimed;
    double factor = std::clamp(ratio, 0.4, 4.0);
    if (round >= kRounds - kGrowing) factor = std::max(factor, 1.0);
    if (round >= kRounds)
      factor = share > kMost - 0.02 ? std::min(1.3 * ratio * ratio * ratio, 8.0) : 1;
    datum.weight = std::clamp(datum.weight * factor, kLeastWeight, kMostWeight);
  }
  return violated;
}

/// Whether all are passed within their tolerance.
bool CurveFit::fit(std::size_t until, std::size_t begin, std::size_t end) {
  weigh_new(begin, end);
  bool violated = false;
  for (int round = 0; round < kRounds + kExtraRounds; ++round) {
    if (round >= kRounds && !violated) break;
    solve(until, begin, end);
    violated = reweigh(begin, end, round);
  }
  return !violated;
}

/// Around what is missed by too much; false where that cannot be, or was done often enough.
bool CurveFit::double_knots(std::size_t begin, std::size_t end) {
  double from = std::numeric_limits<double>::infinity();
  double to = -1;
  for (std::size_t i = begin; i < end; ++i) {
    const bool spent = data_[i].doubled >= kMostDoublings;
    if (data_[i].exact || spent || missed(data_[i]) <= kMost) continue;
    const auto span = static_cast<double>(span_of(data_[i].u));
    from = std::min(from, span - 1);
    to = std::max(to, span + 2);
  }
  from = std::max(from, static_cast<double>(frozen_));
  to = std::min(to, std::floor(data_[end - 1].u + 1e-9) - (fixed_end_ > 0 ? 1 : 0));
  if (to > from) stretch(from, to);
  return to > from;
}

/// Makes the part between the two twice as long in u.
void CurveFit::stretch(double from, double to) {
  const auto moved = [&](double u) {
    return u <= from ? u : u <= to ? from + 2 * (u - from) : u + (to - from);
  };
  ++doubled_;
  std::vector<Datum> data;
  data.reserve(data_.size() * 2);
  for (const Datum& old : data_) {
    Datum datum = old;
    datum.u = moved(old.u);
    if (old.u > from - kCubic && old.u <= to + kCubic) ++datum.doubled;
    if (!data.empty() && datum.u > from) {
      const Datum last = data.back();
      const double parts = std::max(1.0, std::ceil((datum.u - last.u) / kDatumsApart - 1e-9));
      for (double k = 1; k < parts; ++k) {
        Datum between = datum;
        between.place = last.place + (datum.place - last.place) * (k / parts);
        between.u = last.u + (datum.u - last.u) * (k / parts);
        between.exact = false;
        if (old.exact || last.exact) between.weight = 0;
        data.push_back(between);
      }
    }
    data.push_back(datum);
  }
  data_.swap(data);
  for (double& vertex : vertices_) vertex = moved(vertex);
  const auto more = static_cast<std::size_t>(std::lround(to - from));
  if (fixed_end_ > 0)  // moves with the end of the curve
    controls_.insert(controls_.end() - static_cast<std::ptrdiff_t>(fixed_end_), more,
                     Vector3d::Zero());
  length_ = moved(length_);
}

/// The least change of the controls that are not frozen with which the curve passes it exactly.
void CurveFit::meet(const Datum& datum) {
  const std::size_t span = span_of(datum.u);
  const Basis b = basis(datum.u - static_cast<double>(span));
  double square = 0;
  for (std::size_t k = 0; k <= kCubic; ++k)
    if (span + k >= frozen_) square += b[k] * b[k];
  if (square == 0) return;
  const Vector3d left = datum.place - curve(datum.u, span);
  for (std::size_t k = 0; k <= kCubic; ++k)
    if (span + k >= frozen_) control(span + k) += left * (b[k] / square);
}

double CurveFit::settle() {
  for (;;) {
    const bool last = ended_ && frozen_ + window_ >= count() - fixed_end_;
    const std::size_t until = last ? count() - fixed_end_ : frozen_ + window_;
    controls_.resize(std::max(controls_.size(), until + fixed_end_ - dropped_), Vector3d::Zero());
    const auto lowest = static_cast<double>(frozen_ - std::min(frozen_, kCubic));
    const auto highest = static_cast<double>(until - kCubic);
    std::size_t begin = 0;
    while (begin < data_.size() && data_[begin].u < lowest) ++begin;
    std::size_t end = begin;
    while (end < data_.size() && (last || data_[end].u < highest)) ++end;
    const bool fits = until <= frozen_ || fit(until, begin, end);
    if (!fits && double_knots(begin, end)) continue;
    for (std::size_t i = begin; i < end; ++i) {
      if (data_[i].exact && fixed_end_ == 0) meet(data_[i]);
      worst_ = std::max(worst_, missed(data_[i]));
    }
    if (last) {
      frozen_ = count();
      settled_ = length_;
    } else {
      frozen_ += window_ / 3;
      settled_ = static_cast<double>(frozen_ - kCubic);
    }
    return settled_;
  }
}

CurveFit::Place CurveFit::at(double u) const { return on_span(u, span_of(u)); }

CurveFit::Place CurveFit::on_span(double u, std::size_t span) const {
  const double t = u - static_cast<double>(span);
  const Basis b = basis(t);
  const Basis slope = basis_slope(t);
  const Basis bend = basis_bend(t);
  Place place{Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero()};
  for (std::size_t k = 0; k <= kCubic; ++k) {
    place.place += b[k] * control(span + k);
    place.first += slope[k] * control(span + k);
    place.second += bend[k] * control(span + k);
  }
  return place;
}

void CurveFit::drop(double u) {
  const auto first = static_cast<std::size_t>(std::max(std::floor(u), 0.0));
  const std::size_t kept = std::min(first, frozen_ - std::min(frozen_, kCubic));
  if (kept <= dropped_ + kMostInChord) return;  // not for a few
  controls_.erase(controls_.begin(),
                  controls_.begin() + static_cast<std::ptrdiff_t>(kept - dropped_));
  dropped_ = kept;
  const auto old = std::ranges::find_if(
      data_, [&](const Datum& datum) { return datum.u >= static_cast<double>(kept); });
  data_.erase(data_.begin(), std::min(old, data_.end() - 1));
}

void CurveFit::drop_vertices(std::size_t before) {
  const std::size_t count = std::min(before - dropped_vertices_, vertices_.size());
  vertices_.erase(vertices_.begin(), vertices_.begin() + static_cast<std::ptrdiff_t>(count));
  dropped_vertices_ += count;
}

}  // namespace rob::motion
