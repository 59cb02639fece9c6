#include "motion/ahead/reachable.h"

#include <algorithm>
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

/// Calls visit(row) for all that bounds u on the last `rest` of a piece: at its beginning `here`,
/// since x there is x + 2·u·rest, at its end, and likewise in the middle of a curve.
template <typename Visit>
void each_row(const Piece& piece, const PathPoint& here, const PathPoint& end, double rest,
              Visit&& visit) noexcept {
  const bool curve = piece.count > 3 && !piece.averaged();
  const PathPoint middle = curve ? piece.point(piece.length - rest / 2) : here;
  for (int i = 0; i < piece.acceleration.size(); ++i) {
    const double most = piece.acceleration[i];
    if (piece.averaged()) {
      const double slope = piece.slopes[i];
      const double bend = piece.bends[i];
      visit(Row{slope, bend, most, i});
      visit(Row{-slope, bend, most, i});
      visit(Row{slope + 2 * rest * bend, bend, most, i});
      visit(Row{-slope + 2 * rest * bend, bend, most, i});
      visit(Row{piece.swings[i], 0, most, i});
      continue;
    }
    visit(Row{here.qd[i], here.qdd[i], most, i});
    if (curve) visit(Row{middle.qd[i] + rest * middle.qdd[i], middle.qdd[i], most, i});
    if (!piece.straight()) visit(Row{end.qd[i] + 2 * rest * end.qdd[i], end.qdd[i], most, i});
  }
}

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

Bounds bounds_at(const Piece& piece, const PathPoint& here, const PathPoint& end, double rest,
                 double x, double given = kRounding) noexcept {
  Bounds bounds;
  each_row(piece, here, end, rest, [&](const Row& row) { bounds.take(row, x, given); });
  return bounds;
}

/// With `more` times the acceleration.
Bounds raised_bounds(const Piece& piece, const PathPoint& here, const PathPoint& end, double rest,
                     double x, double more) noexcept {
  Bounds bounds;
  each_row(piece, here, end, rest, [&](Row row) {
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
  Bounds bounds = bounds_at(piece, here, end, rest, x, curve ? kBetween : kRounding);
  double more = kFirst;
  for (int i = 0; i < kTries && bounds.low.value(x) > bounds.high.value(x); ++i, more *= kMore)
    bounds = raised_bounds(piece, here, end, rest, x, 1 + more);
  const double low = bounds.low.value(x);
  if (low > bounds.high.value(x)) {  // then no axis more than it has for σ'' alone
    const double most = even_braking(piece, here, end, 0);
    const double u = std::clamp((low + bounds.high.value(x)) / 2, -most, most);
    return {u, u, bounds.low.axis, bounds.high.axis, u};
  }
  ControlRange range{low, bounds.high.value(x), bounds.low.axis, bounds.high.axis, low};
  if (curve) {
    const Bounds raised = raised_bounds(piece, here, end, rest, x, kToStay);
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
  double x = cap;
  each_row(piece, here, end, length, [&](const Row& row) {
    if (row.slope == 0 && row.bend != 0) x = std::min(x, row.most / std::abs(row.bend));
  });
  // The width of the range of u is concave in x and not below 0 at 0: from the right Newton's steps
  // lead to the greatest x at which there is a u, and cross one bound at each.
  constexpr int kMostSteps = 40;
  constexpr double kBeside = 1 - 1e-9;
  for (int step = 0; step < kMostSteps; ++step) {
    Bounds bounds = bounds_at(piece, here, end, length, x);
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
