#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "motion/generate/motion_event.h"
#include "motion/generate/rest.h"
#include "motion/plan/look_ahead_buffer.h"
#include "motion/space/spsc_ring.h"

namespace rob::motion {

/// The reports of a generator, in order of time. One thread reports, one takes. The constructor
/// takes memory; every other call may be used in the tick.
class EventQueue {
 public:
  EventQueue() : events_(kEvents), rests_(kRests) {}

  bool take(MotionEvent& event) noexcept { return events_.take(event); }
  bool take(Rest& rest) noexcept { return rests_.take(rest); }

  bool full() const noexcept { return events_.full(); }
  /// s: the latest instant that was reported or reached. Nothing is reported with an earlier one.
  double latest() const noexcept { return latest_; }
  void reach(double instant) noexcept { latest_ = std::max(latest_, instant); }
  void report(MotionEvent event) noexcept {
    event.time = latest_ = std::max(latest_, event.time);
    events_.push(event);
  }
  /// The same of a Rest at `time`, s; `number`: of the segment that runs then.
  void report(Rest rest, double time, std::uint32_t number) noexcept {
    rest.time = time;
    rests_.push(rest);
    report({.kind = MotionEvent::Kind::Rest, .time = time, .tag = rest.tag, .number = number});
  }

  /// The same of a fault: nothing more is begun from then on.
  void report_fault(const MotionEvent& event) noexcept {
    faulted_ = true;
    report(event);
  }
  bool faulted() const noexcept { return faulted_; }

 private:
  /// [choice: four times what the buffer's effects can make in one period; taken every period]
  static constexpr std::size_t kEvents = 4 * LookAheadBuffer::kEffects;
  /// Each is a barrier for the program; two may follow each other within one period.
  static constexpr std::size_t kRests = 8;

  SpscRing<MotionEvent> events_;
  SpscRing<Rest> rests_;
  double latest_ = 0;
  bool faulted_ = false;
};

}  // namespace rob::motion
