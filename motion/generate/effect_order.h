#pragma once

#include <cstdint>

#include "motion/generate/event_queue.h"
#include "motion/generate/watch_list.h"
#include "motion/plan/look_ahead_buffer.h"

namespace rob::motion {

/// Lets the effects of the LookAheadBuffer act in motion order.
///
/// An effect after segment n is due where the path passes n's target. One that comes later than
/// that, or before any motion, is due at once. Where a generation ends early, the effects of what
/// has not been done are dropped. Every call may be used in the tick.
class EffectOrder {
 public:
  EffectOrder(LookAheadBuffer& buffer, WatchList& watches, EventQueue& events) noexcept
      : buffer_(buffer), watches_(watches), events_(events) {}

  /// Those after motions up to `number` are due.
  void pass(std::uint32_t number) noexcept { passed_ = number; }
  bool passed(std::uint32_t number) const noexcept { return passed_ >= number; }
  std::uint32_t passed() const noexcept { return passed_; }

  /// Generations up to this one have ended; of the last one the effects up to number `keep` act.
  void end(std::uint32_t generation) noexcept { ended_ = generation; }
  void keep(std::uint32_t number) noexcept { kept_ = number; }
  bool has_ended(std::uint32_t generation) const noexcept { return generation <= ended_; }

  /// Whether one is still to come.
  bool pending() const noexcept { return buffer_.next_effect() != nullptr; }
  /// Reports those that are due, in their order. The first for which waits(effect) holds waits, and
  /// all after it; so they do while the events are full. `time`: s.
  template <typename Waits>
  void act(double time, Waits&& waits) noexcept {
    for (const Effect* effect = buffer_.next_effect(); effect != nullptr && !events_.full();
         effect = buffer_.next_effect()) {
      const bool dropped = has_ended(effect->generation) && effect->after > kept_;
      if (!dropped && (!passed(effect->after) || waits(*effect))) return;
      report(*effect, dropped, time);
      buffer_.pop_effect();
    }
  }

 private:
  void report(const Effect& effect, bool dropped, double time) noexcept;

  LookAheadBuffer& buffer_;
  WatchList& watches_;
  EventQueue& events_;
  std::uint32_t passed_ = 0;
  std::uint32_t ended_ = 0;
  std::uint32_t kept_ = 0;
};

}  // namespace rob::motion
