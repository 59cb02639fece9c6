#include "motion/ahead/reachable.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rob::motion {

namespace {

constexpr double kAny = Piece::kAny;

/// |slope·u + bend·x| <= most
struct Row {
  double slope = 0;
  double bend = 0;
  double most = 0;
  int axis = -1;
};

/// Between the ends of a curve's stretch, as shares of it. [choice] Where its bend rises from 0
/// while the guide brakes, as where a corner begins, an axis asks for s·(1 − s/2p), and is held at
/// both ends where p > √2 − 1: nowhere does it ask for more than 2 % above the greatest of these.
constexpr std::array kWithin = {0.2, 0.4, 0.5, 0.6, 0.8};

/// The last `rest` of a piece, from `here`, and where on it the axes are held.
class Stretch {
 public:
  Stretch(const Piece& piece, const PathPoint& here, const PathPoint& end, double rest) noexcept
      : piece_(piece),
        here_(here),
        end_(end),
        rest_(rest),
        curve_(piece.count > 3 && !piece.averaged()) {
    for (std::size_t k = 0; curve_ && k < kWithin.size(); ++k)
      within_[k] = piece.point(piece.length - rest + kWithin[k] * rest);
  }

  /// Calls visit(row) for all that bounds u: at the beginning, at the end, since x there is
  /// x + 2·u·rest, and likewise within a curve.
  template <typename Visit>
  void each_row(Visit&& visit) const noexcept {
    for (int i = 0; i < piece_.acceleration.size(); ++i) {
      const double most = piece_.acceleration[i];
      if (piece_.averaged()) {
        averaged_rows(i, visit);
        continue;
      }
      visit(Row{here_.qd[i], here_.qdd[i], most, i});
      for (std::size_t k = 0; curve_ && k < kWithin.size(); ++k)
        visit(row(within_[k], kWithin[k] * rest_, i));
      if (!piece_.straight()) visit(row(end_, rest_, i));
    }
  }

 private:
  Row row(const PathPoint& there, double way, int axis) const noexcept {
    const double bend = there.qdd[axis];
    return {there.qd[axis] + 2 * way * bend, bend, piece_.acceleration[axis], axis};
  }
  template <typename Visit>
  void averaged_rows(int i, Visit&& visit) const noexcept {
    const double most = piece_.acceleration[i];
    const double slope = piece_.slopes[i];
    const double bend = piece_.bends[i];
    visit(Row{slope, bend, most, i});
    visit(Row{-slope, bend, most, i});
    visit(Row{slope + 2 * rest_ * bend, bend, most, i});
    visit(Row{-slope + 2 * rest_ * bend, bend, most, i});
    visit(Row{piece_.swings[i], 0, most, i});
  }

  const Piece& piece_;
  const PathPoint& here_;
  const PathPoint& end_;
  const double rest_;
  const bool curve_;
  std::array<PathPoint, kWithin.size()> within_;
};

/// A bound of u: slope·u + bend·x = most. One quotient, so that what cancels above a slope of next
/// to nothing cancels exactly.
struct Bound {
  double most = 0;
  double bend = 0;
  double slope = 1;
  int axis = -1;
  double value(double x) const noexcept { return (most - bend * x) / slope; }
  double per() const noexcept { return -bend / slope; }
};

/// Both bounds that are the tightest at x.
struct Bounds {
  Bound low{-kAny};
  Bound high{kAny};

  /// Where a bend asks for just what there is, or for so many times that, u must not come to its
  /// help: above a slope of next to nothing that would take a control without end.
  void take(const Row& row, double x, double given) noexcept {
    if (row.slope == 0) return;
    const double bent = std::abs(row.bend) * x;
    const double most = bent <= row.most * given ? std::max(row.most, bent) : row.most;
    const double up = row.slope > 0 ? most : -most;
    const Bound below{-up, row.bend, row.slope, row.axis};
    const Bound above{up, row.bend, row.slope, row.axis};
    if (below.value(x) > low.value(x)) low = below;
    if (above.value(x) < high.value(x)) high = above;
  }
};

constexpr double kRounding = 1 + 1e-9;

Bounds bounds_at(const Stretch& stretch, double x, double given = kRounding) noexcept {
  Bounds bounds;
  stretch.each_row([&](const Row& row) { bounds.take(row, x, given); });
  return bounds;
}

/// With `more` times the acceleration.
Bounds raised_bounds(const Stretch& stretch, double x, double more) noexcept {
  Bounds bounds;
  stretch.each_row([&](Row row) {
    row.most *= more;
    bounds.take(row, x, kRounding);
  });
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
  Bounds bounds = bounds_at(stretch, x, curve ? kBetween : kRounding);
  double more = kFirst;
  for (int i = 0; i < kTries && bounds.low.value(x) > bounds.high.value(x); ++i, more *= kMore)
    bounds = raised_bounds(stretch, x, 1 + more);
  const double low = bounds.low.value(x);
  if (low > bounds.high.value(x)) {  // then no axis more than it has for σ'' alone
    const double most = even_braking(piece, here, end, 0);
    const double u = std::clamp((low + bounds.high.value(x)) / 2, -most, most);
    return {u, u, bounds.low.axis, bounds.high.axis, u};
  }
  ControlRange range{low, bounds.high.value(x), bounds.low.axis, bounds.high.axis, low};
  if (curve) {
    const Bounds raised = raised_bounds(stretch, x, kToStay);
    range.lowest = std::min(low, raised.low.value(x));
  }
  return range;
}

double even_braking(const Piece& piece, const PathPoint& here, const PathPoint& end,
                    double x) noexcept {
  double most = kAny;
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
  return most;
}

StraightControl straight_control(const Piece& piece) noexcept {
  StraightControl control{kAny, -1};
  for (int i = 0; i < piece.acceleration.size(); ++i) {
    const double slope = piece.averaged() ? piece.swings[i] : std::abs(piece.terms[1][i]);
    const double most = piece.acceleration[i];
    if (slope * control.most > most) control = {most / slope, i};
  }
  return control;
}

double reachable_square(const Piece& piece, double end_square, double cap) noexcept {
  const double length = piece.length;
  if (piece.straight() && !piece.averaged())
    return std::min(cap, end_square + 2 * straight_control(piece).most * length);
  const PathPoint here = piece.point(0);
  const PathPoint end = piece.point(length);
  const Stretch stretch(piece, here, end, length);
  double x = cap;
  stretch.each_row([&](const Row& row) {
    if (row.slope == 0 && row.bend != 0) x = std::min(x, row.most / std::abs(row.bend));
  });
  // The width of the range of u is concave in x and not below 0 at 0: from the right Newton's steps
  // lead to the greatest x at which there is a u, and cross one bound at each.
  constexpr int kMostSteps = 40;
  constexpr double kBeside = 1 - 1e-9;
  for (int step = 0; step < kMostSteps; ++step) {
    Bounds bounds = bounds_at(stretch, x);
    // x + 2·u·length <= end_square, and not below 0
    const Bound to_end{end_square, 1, 2 * length};
    if (to_end.value(x) < bounds.high.value(x)) bounds.high = to_end;
    const Bound to_rest{0, 1, 2 * length};
    if (to_rest.value(x) > bounds.low.value(x)) bounds.low = to_rest;
    const double width = bounds.high.value(x) - bounds.low.value(x);
    if (width >= 0) return x;
    const double fall = bounds.high.per() - bounds.low.per();
    if (!(fall < 0)) return 0;
    // Of a slope of next to nothing the bound is as good as upright, and rounding where it stands.
    x = std::max(std::min(x - width / fall, x * kBeside), 0.0);
  }
  return x;
}

}  // namespace rob::motion
