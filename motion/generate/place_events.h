#pragma once

#include <array>
#include <cstddef>
#include <optional>

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
  /// A LEAD that was not kept: what the guide did was not what had been foreseen.
  struct Missed {
    Tag tag = 0;
    double time = 0;   ///< the references passed the place
    double error = 0;  ///< s by which the event came too early; below 0: too late
  };
  /// One at a time; those by less than `tolerance`, s, count as kept.
  std::optional<Missed> take_missed(const GuideHistory& history, double now, double lag,
                                    double tolerance) noexcept;
  void drop() noexcept { count_ = led_count_ = 0; }
  /// The history begins anew.
  void begin_run() noexcept { led_count_ = 0; }

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

  /// What came before its place, until that is passed.
  struct Led {
    Tag tag = 0;
    double sigma = 0;
    double lead = 0;
    double came = 0;
  };
  void remember(const Entry& entry, double due, double now) noexcept;

  std::array<Led, kMost> led_;
  std::size_t led_count_ = 0;
  double looked_ = 0;  ///< the last look, and the one before
  double before_ = 0;
  std::array<Entry, kMost> entries_;
  std::size_t count_ = 0;
  Effect taken_;
};

}  // namespace rob::motion
