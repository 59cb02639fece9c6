#pragma once

#include "motion/ahead/piece.h"

namespace rob::motion {

/// How σ'' may be chosen on a stretch of a piece that is entered with σ'² = x, so that every axis
/// keeps its acceleration q_σ·u + q_σσ·σ'² at both of its ends, on a curve at some places between,
/// too. On a straight piece or a parabola that is: everywhere on it. low > high: x is too fast.
struct ControlRange {
  double low = 0;   ///< m/s²
  double high = 0;  ///< m/s²
  int low_axis = -1;
  int high_axis = -1;
  double lowest = 0;  ///< m/s²: what keeps to the squares may use a little more than the axes have
};

/// From `at` (σ − begin) to the end of the piece. `here`, `end`: the piece there.
ControlRange control_range(const Piece& piece, const PathPoint& here, const PathPoint& end,
                           double rest, double x) noexcept;

/// How hard σ' can be braked evenly on all of the rest of a piece, as long as σ'² is at most x;
/// m/s², not below 0.
double even_braking(const Piece& piece, const PathPoint& here, const PathPoint& end,
                    double x) noexcept;

/// The greatest |σ''| on a straight piece, and the axis that sets it.
struct StraightControl {
  double most = 0;
  int axis = -1;
};
StraightControl straight_control(const Piece& piece) noexcept;

/// The greatest σ'² at the beginning of a piece, at most `cap`, from which one σ'' leads to at
/// most `end_square` at its end: a step of the backward pass over controllable sets (Pham and Pham
/// 2018, TOPP-RA), constrained at both ends. Every σ'² below it is as good, since 0 is.
double reachable_square(const Piece& piece, double end_square, double cap) noexcept;

}  // namespace rob::motion
