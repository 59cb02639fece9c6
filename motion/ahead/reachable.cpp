#include "motion/ahead/reachable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace rob::motion {

namespace {

/// |slope·u + bend·x| <= most. Without values of its own, which an array of many would wait for.
struct Row {
  double slope;
  double bend;
  double most;
  int axis;
};

/// Between the ends of a curve's stretch, as shares of it. [choice] Where its bend rises from 0
/// while the guide brakes, as where a corner begins, an axis asks for s·(1 − s/2p), and is held at
/// both ends where p > √2 − 1: nowhere does it ask for more than 2 % above the greatest of these.
constexpr std::array kWithin = {0.2, 0.4, 0.5, 0.6, 0.8};

/// The last `rest` of a piece, from `here`: all that bounds u there.
class Stretch {
 public:
  Stretch(const Piece& piece, const PathPoint& here, const PathPoint& end, double rest) noexcept
      : piece_(piece) {
    if (piece.averaged()) {
      add_averaged(rest);
    } else if (piece.count > 3) {
      add_curve(here, end, rest);
    } else {
      for (int i = 0; i < piece.acceleration.size(); ++i) {
        add(i, here, 0);
        if (!piece.straight()) add(i, end, rest);
      }
    }
    if (piece.torqued()) add_torque(rest);
  }

  std::span<const Row> rows() const noexcept { return {rows_.data(), count_}; }
  /// The greatest x that leaves something of what bends where u cannot help.
  double bent_square() const noexcept { return bent_square_; }

 private:
  void add_curve(const PathPoint& here, const PathPoint& end, double rest) noexcept {
    std::array<PathPoint, kWithin.size()> within;
    for (std::size_t k = 0; k < kWithin.size(); ++k)
      within[k] = piece_.point(piece_.length - rest + kWithin[k] * rest);
    for (int i = 0; i < piece_.acceleration.size(); ++i) {
      add(i, here, 0);
      for (std::size_t k = 0; k < kWithin.size(); ++k) add(i, within[k], kWithin[k] * rest);
      add(i, end, rest);
    }
  }
  void add_averaged(double rest) noexcept {
    for (int i = 0; i < piece_.acceleration.size(); ++i) {
      const double slope = piece_.slopes[i];
      const double bend = piece_.bends[i];
      add(i, slope, bend);
      add(i, -slope, bend);
      add(i, slope + 2 * rest * bend, bend);
      add(i, -slope + 2 * rest * bend, bend);
      add(i, piece_.swings[i], 0);
    }
  }
  /// As of an axis with the mean of σ.
  void add_torque(double rest) noexcept {
    const auto& [slope, bend, fastest, axis] = piece_.torque;
    for (const double way : {0.0, rest})
      for (const double sign : {1.0, -1.0}) add(axis, sign * slope + 2 * way * bend, bend, 1);
  }
  /// `way` after the beginning of the stretch, since x there is x + 2·u·way.
  void add(int axis, const PathPoint& place, double way) noexcept {
    add(axis, place.qd[axis] + 2 * way * place.qdd[axis], place.qdd[axis]);
  }
  void add(int axis, double slope, double bend) noexcept {
    add(axis, slope, bend, piece_.acceleration[axis]);
  }
  void add(int axis, double slope, double bend, double most) noexcept {
    if (slope != 0) {
      rows_[count_++] = {slope, bend, most, axis};
    } else if (bend != 0) {
      bent_square_ = std::min(bent_square_, most / std::abs(bend));
    }
  }

  const Piece& piece_;
  std::array<Row, kMaxJoints*(2 + kWithin.size()) + 4> rows_;
  std::size_t count_ = 0;
  double bent_square_ = Piece::kAny;
};

/// The range of u at one x, and the rows that bound it.
struct Bounds {
  double low = -Piece::kAny;
  double high = Piece::kAny;
  const Row* low_row = &kNone;
  const Row* high_row = &kNone;

  /// By which the range grows with x.
  double widening() const noexcept {
    return low_row->bend / low_row->slope - high_row->bend / high_row->slope;
  }

  static constexpr Row kNone{1, 0, Piece::kAny, -1};
};

constexpr double kRoundedUp = 1 + 1e-9;

/// With `more` times the acceleration. Where a bend asks for just what there is, or for `given`
/// times that, u must not come to its help: above a slope of next to nothing that would take a
/// control without end. One quotient a bound, so that what cancels above such a slope cancels
/// exactly.
Bounds bounds_at(const Stretch& stretch, double x, double given = kRoundedUp,
                 double more = 1) noexcept {
  Bounds bounds;
  for (const Row& row : stretch.rows()) {
    const double bent = row.bend * x;
    const double has = row.most * more;
    const double most = std::abs(bent) <= has * given ? std::max(has, std::abs(bent)) : has;
    const double up = std::copysign(most, row.slope);
    const double low = (-up - bent) / row.slope;
    const double high = (up - bent) / row.slope;
    bounds.low_row = low > bounds.low ? &row : bounds.low_row;
    bounds.low = std::max(low, bounds.low);
    bounds.high_row = high < bounds.high ? &row : bounds.high_row;
    bounds.high = std::min(high, bounds.high);
  }
  return bounds;
}

}  // namespace

ControlRange control_range(const Piece& piece, const PathPoint& here, const PathPoint& end,
                           double rest, double x) noexcept {
  // Between the ends of a piece a curve can ask for a little more than there: so much is given to
  // its bends. If that does not do, all axes give as little more as will.
  constexpr double kBetween = 1 + 5e-4;
  // To stay where the end can be reached from, so much: beyond, a bend asks for ever more.
  constexpr double kToStay = 1.01;
  constexpr double kFirst = 1e-4;
  constexpr double kMore = 1.5;
  constexpr int kTries = 16;
  const bool curve = piece.count > 3;
  const Stretch stretch(piece, here, end, rest);
  Bounds bounds = bounds_at(stretch, x, curve ? kBetween : kRoundedUp);
  double more = kFirst;
  for (int i = 0; i < kTries && bounds.low > bounds.high; ++i, more *= kMore)
    bounds = bounds_at(stretch, x, kRoundedUp, 1 + more);
  if (bounds.low > bounds.high) {  // then no axis more than it has for σ'' alone
    const double most = even_braking(piece, here, end, 0);
    const double u = std::clamp((bounds.low + bounds.high) / 2, -most, most);
    return {u, u, bounds.low_row->axis, bounds.high_row->axis, u};
  }
  ControlRange range{bounds.low, bounds.high, bounds.low_row->axis, bounds.high_row->axis,
                     bounds.low};
  if (curve) range.lowest = std::min(range.low, bounds_at(stretch, x, kRoundedUp, kToStay).low);
  return range;
}

double even_braking(const Piece& piece, const PathPoint& here, const PathPoint& end,
                    double x) noexcept {
  double most = Piece::kAny;
  for (int i = 0; i < piece.acceleration.size(); ++i) {
    const bool mean = piece.averaged();
    const double slope =
        mean ? piece.slopes[i] : std::max(std::abs(here.qd[i]), std::abs(end.qd[i]));
    const double bend =
        mean ? piece.bends[i] : std::max(std::abs(here.qdd[i]), std::abs(end.qdd[i]));
    if (slope > 0) most = std::min(most, std::max(piece.acceleration[i] - bend * x, 0.0) / slope);
    if (mean && piece.swings[i] * most > piece.acceleration[i])
      most = piece.acceleration[i] / piece.swings[i];
  }
  if (piece.torque.slope > 0)
    most = std::min(most, std::max(1 - piece.torque.bend * x, 0.0) / piece.torque.slope);
  return most;
}

StraightControl straight_control(const Piece& piece) noexcept {
  StraightControl control{Piece::kAny, -1};
  for (int i = 0; i < piece.acceleration.size(); ++i) {
    const double slope = piece.averaged() ? piece.swings[i] : std::abs(piece.terms[1][i]);
    const double most = piece.acceleration[i];
    if (slope * control.most > most) control = {most / slope, i};
  }
  return control;
}

double reachable_square(const Piece& piece, double end_square, double cap) noexcept {
  const double length = piece.length;
  if (piece.straight() && !piece.averaged() && !piece.torqued())
    return std::min(cap, end_square + 2 * straight_control(piece).most * length);
  const PathPoint here = piece.point(0);
  const PathPoint end = piece.point(length);
  const Stretch stretch(piece, here, end, length);
  double x = std::min(cap, stretch.bent_square());
  Row to_end = Bounds::kNone;  // 0 <= x + 2·u·length <= end_square
  to_end.slope = 2 * length;
  to_end.bend = 1;
  // The width of the range of u is concave in x and not below 0 at 0: from the right Newton's steps
  // lead to the greatest x at which there is a u, and cross one bound at each.
  constexpr int kMostSteps = 40;
  constexpr double kBeside = 1 - 1e-9;
  for (int step = 0; step < kMostSteps; ++step) {
    Bounds bounds = bounds_at(stretch, x);
    if (const double high = (end_square - x) / (2 * length); high < bounds.high) {
      bounds.high = high;
      bounds.high_row = &to_end;
    }
    if (const double low = -x / (2 * length); low > bounds.low) {
      bounds.low = low;
      bounds.low_row = &to_end;
    }
    const double width = bounds.high - bounds.low;
    if (width >= 0) return x;
    const double fall = bounds.widening();
    if (!(fall < 0)) return 0;
    // With a slope of next to nothing the bound is as good as upright, and rounding where it
    // stands.
    x = std::max(std::min(x - width / fall, x * kBeside), 0.0);
  }
  return x;
}

}  // namespace rob::motion
