#pragma once

#include <cstdint>
#include <memory>
#include <variant>

#include "motion/plan/feasibility.h"
#include "motion/plan/leg_demand.h"
#include "motion/plan/planned_leg.h"
#include "motion/plan/segment_descriptor.h"

namespace rob::motion {

/// A motion that can be, and what its asker should know of it.
struct PlannedSegment {
  /// AT asks for more than the axes it names can do; they go as fast as they can.
  static constexpr std::uint8_t kPaceCut = 1;
  /// The axes or the corners need longer than OVER asks; segment.duration is the true time, under
  /// the look-ahead law the least.
  static constexpr std::uint8_t kStretched = 2;
  /// ZONE asks for a tighter corner than the axes can take; segment.t_acc is the least.
  static constexpr std::uint8_t kZoneRaised = 4;
  /// No corner leads from the motion before into this one within what the axes can do: its target
  /// is reached exactly.
  static constexpr std::uint8_t kCornerExact = 8;
  /// ACCEL or JERK asks for more than the axes can do.
  static constexpr std::uint8_t kBoundCut = 16;
  /// The ZONE of the motion `zone_tag`, which was before this one, cannot be used in full: one of
  /// the two is too short for it, and leaves `zone_left` at most.
  static constexpr std::uint8_t kZoneCut = 32;

  SegmentDescriptor segment;
  std::uint8_t warnings = 0;                ///< kPaceCut | kStretched | …
  std::shared_ptr<const PlannedLeg> leg{};  ///< what the segment points into; null: nothing
  Tag zone_tag = 0;
  double zone_left = 0;  ///< m
  PaceCut pace_cut{};    ///< of kPaceCut
};

using PlanOutcome = std::variant<PlannedSegment, Refusal>;

}  // namespace rob::motion
