#pragma once

#include <optional>

#include "motion/ahead/path_shape.h"

namespace rob::motion {

/// The bounds of a corner, beside the zone of its point.
struct TurnBounds {
  double longest = 0;      ///< m of σ that it may take on each side
  double average = 0;      ///< s of the mean that follows, which moves a curve of the axes inwards
  bool of_sigma = false;   ///< the mean is of σ: the path is kept, and has to bend smoothly
  bool from_rest = false;  ///< the leg into it begins at rest
  bool whole_run = false;  ///< and the leg out of it ends at rest
  bool to_rest = true;     ///< the leg out of it could do with a stop at its end
};

/// How long the corner between two legs would like to be: what its zone admits, or what its speed
/// needs where that is less. m of σ on each side.
double wanted_half(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out);

/// The corner of the greatest length that keeps its bounds; of no length where the legs go straight
/// on. None where only a stop will do.
///
/// Between legs straight in the axes it is a parabola: even acceleration is what leads around a
/// corner the fastest within a given miss, which is |q'₂ − q'₁|·half/4. Between lines of the tool
/// it is Paul's quartic of the tool, else a quintic of the axes; what they miss is measured.
std::optional<Turn> make_turn(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                              const TurnBounds& bounds);

}  // namespace rob::motion
