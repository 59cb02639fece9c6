#pragma once

#include "motion/kinematics/kinematics.h"
#include "motion/plan/segment_descriptor.h"

namespace rob::motion {

/// How far the reference curve of Paul's law passes from a via point: the least distance, m, of
/// the tool's tip in the corner from its place at `via`. The axes come with `incoming` and leave
/// with `outgoing` (m/s, rad/s); the corner lasts 2·t_acc. 0 where the point is met exactly.
/// `tip`: the tip's place seen from the flange, m.
double corner_miss(const Kinematics& kinematics, const JointVector& via,
                   const JointVector& incoming, const JointVector& outgoing, double t_acc,
                   const Eigen::Vector3d& tip = Eigen::Vector3d::Zero());

/// The miss at the target of segment `in`, which began at `from` and is followed by `out`.
double corner_miss(const Kinematics& kinematics, const JointVector& from, const SegmentMotion& in,
                   const SegmentMotion& out, const Eigen::Vector3d& tip = Eigen::Vector3d::Zero());

}  // namespace rob::motion
