#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "motion/plan/segment_descriptor.h"

namespace rob::motion {

/// The path events of the motions under way: at which path time each is due.
///
/// A place is a share of its leg. Where the leg is joined by a corner, the share is that of the
/// leg's own time, so that its ends are the middles of the corners: where the motion would pass the
/// place if it did not round them. Where the leg begins or ends at rest the place itself is passed.
///
/// s of path time. Every call may be used in the tick.
class PathEvents {
 public:
  /// A leg of `leg`'s duration begins, with its first target at path time `zero` (t = 0 of S1) and
  /// half the transition around it `t_before`; `instant`: now. `rate`: path time per run time, for
  /// LEAD and LAG.
  void begin(const SegmentDescriptor& leg, double zero, double t_before, bool from_rest,
             double instant, double rate) noexcept;
  /// The leg ends at rest, by a stop that begins t_acc before its target would be reached.
  void stop(double t_acc) noexcept;
  /// The effect that is due at `path_time` of motions up to `number`, the earliest first; null:
  /// nothing.
  const Effect* take(double path_time, std::uint32_t number, double& due) noexcept;
  /// s by which what was taken last came later than its LEAD asked for, since it cannot come before
  /// its motion begins; 0: it did not.
  double cut() const noexcept { return cut_; }
  bool pending() const noexcept { return count_ > 0; }
  /// An effect that is not due yet is never done.
  void drop() noexcept { count_ = 0; }

 private:
  struct Entry {
    double due = 0;
    double share = 0;
    double shift = 0;  ///< path time by which it is due before its place
    double cut = 0;    ///< by which it is due later than that
    Effect effect;
  };

  /// Two legs; the shifts are shorter than any.
  static constexpr std::size_t kMost = 2 * EventsOnTheWay::kMost;

  std::array<Entry, kMost> entries_;
  std::size_t count_ = 0;
  Effect taken_;
  double cut_ = 0;
  double leg_zero_ = 0;
  double leg_duration_ = 0;
  std::uint32_t leg_ = 0;  ///< its number
};

}  // namespace rob::motion
