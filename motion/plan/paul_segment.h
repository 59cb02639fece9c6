#pragma once

#include "motion/path/paul_transition.h"
#include "motion/plan/segment_descriptor.h"

namespace rob::motion {

/// The path of one segment under Paul's law, whatever it runs along, as a function of S1's t:
///
///   in the axes      PaulTransition, the transition around B and the straight part
///   along a path     the same polynomial on the path's own parameter, from or to rest
///   out of a corner  the leg before up to −half, the prepared corner, the new leg from half on
///   a profile        its own law from rest to rest; t is 0 at its beginning
///
/// m, rad, s. Every call may be used in the tick.
class PaulSegment {
 public:
  /// The axes are at `a`, t_acc before `segment` leaves them at B, the target before; with
  /// `from_rest` they stand there.
  void begin(const SegmentDescriptor& segment, const JointVector& a, const JointVector& b,
             double t_acc, bool from_rest) noexcept;
  /// They come to rest at the target of the current leg, t_acc before which they are, and stand
  /// there until t = `duration`.
  void stop(const JointVector& a, const JointVector& b, double t_acc, double duration) noexcept;

  PathPoint sample(double t) const noexcept;

 private:
  enum class Kind : std::uint8_t { Axes, Ramp, Corner, Profile };

  Kind kind_ = Kind::Axes;
  PaulTransition law_;  ///< of the axes; Ramp: of the leg's parameter alone
  LegMotion leg_;
  LegMotion before_;
  const Corner* corner_ = nullptr;
  ProfileLaw profile_;
};

}  // namespace rob::motion
