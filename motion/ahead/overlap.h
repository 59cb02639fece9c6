#pragma once

#include <optional>

#include "motion/ahead/path_shape.h"

namespace rob::motion {

/// How two straight legs overlap. The guide comes to rest at the point between them and starts the
/// second leg before the mean of the first has settled, so the mean rounds the point.
struct Overlap {
  double share = 1;  ///< of the second leg's accelerations
  double wait = 0;   ///< s for which the guide stands at the point
  double won = 0;    ///< s by which that is faster than a stop
};

/// `in` has its share of the acceleration already; `average`: s, its mean. Returns none if the legs
/// cannot overlap within the zone and the jerk, or if a stop is as fast. Legs of similar direction
/// exceed the jerk, because one still brakes while the other speeds up.
std::optional<Overlap> overlap_of(const RobotModel& robot, const ShapedLeg& in,
                                  const ShapedLeg& out, double average);

/// The best mean for the first of two legs: longer than alone if the overlap gains more than the
/// leg loses. `made`: the leg alone.
LegAlone with_overlap(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                      const LegAlone& made);

/// s that an overlap saves two legs with a stop between them; 0 if they cannot overlap.
double won_by_overlap(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out);

}  // namespace rob::motion
