#pragma once

#include <limits>
#include <vector>

#include "motion/ahead/path_shape.h"

namespace rob::motion {

/// The effect of the mean of the references on a corner of the axes: it moves it inwards. The
/// distance is taken off its zone, and bounded, by the accelerations in the corner and around it.
///
/// A mean over T of accelerations up to a lies up to a·T²/24 beside what it is of. At the corner's
/// middle those along its bend count, of all that is passed within T/2 of it: around a gentle
/// corner the bend itself, and of both legs what their direction has of it; around a sharp one all
/// that the axes give, and so around one with a corner of a stricter zone within T/2 of it.
struct MeanShift {
  static constexpr double kAny = std::numeric_limits<double>::infinity();
  double part = 1;      ///< of the zone, left to the corner
  double turns = kAny;  ///< m/s² per unit of turn that the bend may have: σ'²/(2·half)
  double calm = 1;      ///< share of the axes' accelerations to be used around the corner
};

/// `turn`: by which dq/dσ changes; `average`: T, s; `longest`: m of σ that the corner may take on
/// each side.
MeanShift mean_shift(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                     const JointVector& turn, double average, double longest);

/// m/s² per unit of turn: of an even bend that the mean moves by the whole zone. Infinite where
/// there is no mean.
double turns_in_zone(const RobotModel& robot, const ShapedLeg& in, const JointVector& turn,
                     double average);

/// Where two short legs are part of a curve: the share of their accelerations, and of the mean's
/// time with them, at which the mean and the accelerations slow it alike, or neither does. 1 where
/// they are none.
double bend_share(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                  double average);

/// m of σ on each side of a corner's middle that can be passed within T/2 of it: there the calm
/// accelerations hold. `rate`: σ' at the middle.
double calm_way(const ShapedLeg& in, const ShapedLeg& out, double calm, double average,
                double rate);

/// The most of it before the end of a leg, whatever comes after; 0 where no corner there asks for
/// it, unless for the zone of a point after it, which is not known yet.
double longest_calm_way(const RobotModel& robot, const ShapedLeg& leg, double average);

/// Slows the pieces of a curve of the axes so far that its mean is beside it by half of its zones
/// at most.
void bound_by_mean(const RobotModel& robot, const ShapedLeg& leg, double average,
                   std::vector<Piece>& pieces);

}  // namespace rob::motion
