#pragma once

#include "motion/generate/effect_order.h"
#include "motion/generate/event_queue.h"
#include "motion/generate/under_way.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/plan/watched_action.h"

namespace rob::motion {

/// How motions end before their time: by their guard, by a WHEN, by request. The axes brake on
/// their path, beyond the end of the segment if need be, and the rest of its generation is dropped.
///
/// A guarded motion that would begin from standstill while its condition holds does not begin. A
/// guarded motion with nothing after it is a barrier: its Rest says how it ended.
///
/// Where a WHEN raises an error, no effect acts any more from then on. Every call may be used in
/// the tick.
class EarlyEnd {
 public:
  EarlyEnd(UnderWay& now, LookAheadBuffer& buffer, EffectOrder& effects,
           EventQueue& events) noexcept
      : now_(now), buffer_(buffer), effects_(effects), events_(events) {}

  bool braking() const noexcept { return braking_; }
  /// Braking for an error of the program.
  bool failing() const noexcept { return braking_ && rest_.by != nullptr; }
  /// An error has ended motions, and who waits for it has not taken its Rest.
  bool untaken() const noexcept { return untaken_; }
  void take() noexcept { untaken_ = false; }

  /// Asks whether the motion under way shall be braked, and its guard.
  void ask_guard() noexcept;
  /// Whether the guard of a motion that would start from standstill holds: it does not start.
  bool hit_at_start(const SegmentDescriptor& segment, double instant) noexcept;
  /// From now on the axes brake.
  void trip(Rest::Outcome outcome, WatchedAction* by = nullptr) noexcept;
  /// The Rest in the making, while braking.
  const Rest& rest() const noexcept { return rest_; }
  /// The axes stand at the segment's target; its Rest is reported at `time`, s.
  void finish(double time) noexcept;
  /// The braking is over, without a Rest.
  void cancel() noexcept { braking_ = false; }

  /// The motion under way has arrived at `instant`, s, and its guard never held. `next` follows it;
  /// null: nothing is known.
  void close_guard(const SegmentDescriptor* next, double instant) noexcept;

 private:
  UnderWay& now_;
  LookAheadBuffer& buffer_;
  EffectOrder& effects_;
  EventQueue& events_;
  bool braking_ = false;
  Rest rest_;
  bool untaken_ = false;
};

}  // namespace rob::motion
