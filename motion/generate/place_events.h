#pragma once

#include <array>
#include <cstddef>

#include "motion/generate/guide_history.h"
#include "motion/plan/segment_descriptor.h"

namespace rob::motion {

/// The path events of look-ahead motion: each is due when the references pass its place, or `lead`
/// before that. What the guide will do until then is found by stepping a second guide on; exact
/// while override and what is known stay as they are.
///
/// Times are the guide's, s. Every call may be used in the tick.
class PlaceEvents {
 public:
  /// The furthest that a second guide looks, s.
  static constexpr double kFurthest = 0.5;

  /// `sigma`: the place; `earliest`: not before.
  void expect(const PathEvent& event, double sigma, double earliest) noexcept;
  /// What is due at `now`, the earliest first, where references lag by `lag`; null: nothing.
  const Effect* take(const Guide& guide, const GuideHistory& history, double now, double lag,
                     double& due) noexcept;
  void drop() noexcept { count_ = 0; }

 private:
  struct Entry {
    double sigma = 0;
    double lead = 0;
    double earliest = 0;
    bool passed = false;
    double when = 0;  ///< the references pass, or will, the place; once `passed`
    Effect effect;
  };
  /// [choice] the events of eight legs, whose lags may overlap
  static constexpr std::size_t kMost = 8 * SegmentDescriptor::kMostEvents;

  std::array<Entry, kMost> entries_;
  std::size_t count_ = 0;
  Effect taken_;
};

}  // namespace rob::motion
