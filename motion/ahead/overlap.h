#pragma once

#include <optional>

#include "motion/ahead/path_shape.h"

namespace rob::motion {

/// Two straight legs whose guide comes to rest between them: the second begins before the mean of
/// the first has settled, so the mean leads around the point.
struct Overlap {
  double share = 1;  ///< of the second leg's accelerations
  double wait = 0;   ///< s that the guide stands at the point
  double won = 0;    ///< s by which that is faster than a stop
};

/// `average`: s of the mean, that of `in`, which has its share already. None where that is not
/// within the zone or the jerk, or takes longer than a stop: the jerk where the directions are
/// alike, since one leg still brakes while the other speeds up.
std::optional<Overlap> overlap_of(const RobotModel& robot, const ShapedLeg& in,
                                  const ShapedLeg& out, double average);

/// How the first of two legs that overlap is best driven: with a longer mean than alone, since the
/// second begins that much earlier. `made`: alone.
LegAlone with_overlap(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out,
                      const LegAlone& made);

/// s by which a stop between two legs takes less time than each of them alone.
double won_by_overlap(const RobotModel& robot, const ShapedLeg& in, const ShapedLeg& out);

}  // namespace rob::motion
