#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>

#include "motion/ahead/path_ring.h"
#include "motion/ahead/path_shape.h"
#include "motion/plan/sent_boxes.h"

namespace rob::motion {

/// [choice] Motions that one item of the path may carry, those without a way not counted.
inline constexpr std::size_t kMostMembers = 64;

/// Writes the motions that lie on the path into the PathRing, and counts those that are neither
/// merged with others nor short: a program may be only so many of them ahead. Belongs to the
/// planner's thread.
class LegWriter {
 public:
  /// `single`: how many motions in the ring may be ones that are counted.
  LegWriter(const RobotModel& robot, PathRing& ring, std::size_t single)
      : robot_(robot), ring_(ring), single_(single), boxes_(robot) {}

  /// The most motions with a way that an item may carry.
  std::size_t most_members() const noexcept;
  /// There is room for all motions of one item.
  bool fits() noexcept;
  /// `decides`: σ by which the motion after the last of these must be known. `like`: its `average`,
  /// `pauses` and `of_sigma` describe the mean of the run.
  void write(const ShapedLeg& leg, double decides, const PathLeg& like);
  /// Without a way, at σ.
  void write_at(const SegmentDescriptor& segment, double sigma);
  void write_at(const PathItem& item, double sigma);

 private:
  /// Events that were laid anew on a curve are boxed here, not by who has sent the motion.
  void push(const PathLeg& leg);

  const RobotModel& robot_;
  PathRing& ring_;
  std::size_t single_;
  std::uint64_t written_ = 0;
  std::deque<std::uint64_t> singles_;  ///< those in the ring that are counted
  SentBoxes boxes_;
};

}  // namespace rob::motion
