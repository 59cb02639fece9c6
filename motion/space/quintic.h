#pragma once

#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The quintic through position, velocity and acceleration of both references, at a.time <= now
/// <= b.time, a.time < b.time. s, SI. May be used in the tick.
JointReference quintic_between(const JointReference& a, const JointReference& b,
                               double now) noexcept;

}  // namespace rob::motion
