#pragma once

#include <array>
#include <cstdint>

#include "motion/servo/reference_extrapolation.h"
#include "motion/servo/reference_join.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The reference of the axes *now*, out of references that come once a reference period (S2's servo
/// interpolates position, velocity and acceleration between kinematic periods). s, SI.
///
/// Between two neighbouring stamps it follows the quintic through (q, q', q'') of both; at a stamp
/// it returns that reference bit for bit. Without a newer reference it goes on as
/// ReferenceExtrapolation says; when references return it joins them as ReferenceJoin says, so that
/// neither position nor velocity ever jumps. References further apart than kLongestGap periods are
/// not connected by a curve: the later one is taken up one period before its stamp.
///
/// Every call but the constructor may be used in the tick. One thread.
class ReferenceInterpolator {
 public:
  /// As many as may be missing before nothing is known of the path between two references: the
  /// extrapolation's three periods, plus the one that is always between neighbours.
  static constexpr int kLongestGap = ReferenceExtrapolation::kPeriods + 1;

  /// v_max bounds what is extrapolated, a_max the ramp to rest; all three bound the join.
  ReferenceInterpolator(double period, const JointVector& v_max, const JointVector& a_max,
                        const JointVector& j_max);

  /// Stands still at q from `stand.time` on, whatever its velocity; forgets what it had.
  void reset(const JointReference& stand) noexcept;

  /// As reset(), for a machine that has been on its own: the references that come next may lie
  /// anywhere, and are joined as after an extrapolation.
  void rejoin(const JointReference& stand) noexcept;

  /// For a machine that went on by itself for a moment: the way from where it was found, moving, to
  /// where the references are at that instant begins there. `found.time` as `now` of at().
  void join_from(const JointReference& found) noexcept;

  /// Stamps may skip periods. False, and nothing has happened: the stamp is not later than the last
  /// one, or a value is not finite.
  bool push(const JointReference& reference) noexcept;

  /// `now` never goes back. Before the oldest reference that is kept: that reference.
  JointReference at(double now) noexcept;

  /// Periods without a reference after one that moved, since the constructor. Less than half a
  /// period is not counted: it is the jitter of two threads.
  std::uint64_t starved() const noexcept { return starved_; }

  /// True while the way back to the references is not finished.
  bool joining() const noexcept { return join_.active(); }
  /// How far the last at() was from the references, s: the longest time that an axis needs for
  /// that way at its v_max.
  double behind() const noexcept { return join_.behind(); }

 private:
  // Eight: a servo that wakes up late finds at most the generator's last few. [choice]
  static constexpr int kKept = 8;

  const JointReference& kept(int i) const noexcept;
  void drop_oldest() noexcept;
  void drop_passed(double now) noexcept;
  bool gap_follows() const noexcept;
  bool next_is_far(double now) const noexcept;
  JointReference without_join(double now) noexcept;
  bool must_extrapolate(double now) const noexcept;
  JointReference on_references(double now) const noexcept;
  void begin_extrapolation() noexcept;
  double return_instant(double now) const noexcept;
  void return_at(double start) noexcept;
  void count_starvation(double now) noexcept;

  double period_;
  std::array<JointReference, kKept> ring_;
  int first_ = 0;  // oldest; its successor is the next stamp
  int count_ = 0;
  bool extrapolating_ = false;
  double last_ = 0;  // of at()
  ReferenceExtrapolation extrapolation_;
  ReferenceJoin join_;
  std::uint64_t starved_ = 0;
  std::uint64_t starved_here_ = 0;  // since extrapolation_.base()
};

}  // namespace rob::motion
