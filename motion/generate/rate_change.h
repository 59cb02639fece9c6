#pragma once

#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The shares of the missing rate and of the current acceleration that make the acceleration one
/// period on.
struct RateChange {
  double of_missing = 0;       ///< 1/s
  double of_acceleration = 0;  ///< 1
};

/// How to change rates, all together, as soon as acceleration and jerk permit, without overshoot:
///
///     a'                  one period to reach a wanted acceleration a', n more of constant jerk
///     ╱╲___               back to 0, where nothing is missing any more:
///    ╱     ╲___           missing = (a + a')·T/2 + a'·n·T/2,  a' = (2·missing/T − a)/(n + 1)
///   a          0
///
/// n is the least whole number for which |a'| <= a_max and the jerk |a'|/(n·T) <= j_max on every
/// axis; towards a' it is changed by j_max·T at most. Asked in every period it ramps up, goes on
/// and levels off. The missing rate and the acceleration are given by what they make of each axis,
/// so that the answer keeps its directions in whatever space the rates are of. Closed form.
RateChange rate_change(const JointVector& missing, const JointVector& acceleration,
                       const JointVector& a_max, const JointVector& j_max, double period) noexcept;

}  // namespace rob::motion
