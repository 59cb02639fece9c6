#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "motion/plan/segment_descriptor.h"
#include "motion/space/spsc_ring.h"

namespace rob::motion {

/// All that has been commanded and not yet begun, between the program (one writer) and the
/// generator (one reader): S2's buffer of segment descriptors, and beside it the effects in
/// their order. Memory is taken once, by the constructor; no call locks or waits.
class LookAheadBuffer {
 public:
  /// Effects are carried by the motions and have room of their own. [choice: a thousand
  /// outputs between two motions is a program of its own]
  static constexpr std::size_t kEffects = 1024;

  /// `segments`: how many motions the buffer holds (robot file, look_ahead).
  explicit LookAheadBuffer(std::size_t segments) : segments_(segments), effects_(kEffects) {}

  // The program's side. False: full, nothing has happened.
  bool push(const SegmentDescriptor& segment) noexcept {
    if (segment.t_acc < tightest_.load(std::memory_order_relaxed))
      tightest_.store(segment.t_acc, std::memory_order_relaxed);  // known before it is seen
    return segments_.push(segment);
  }
  bool push(const Effect& effect) noexcept { return effects_.push(effect); }
  bool full() const noexcept { return segments_.full(); }
  /// For how many segments there is room.
  std::size_t room() const noexcept { return segments_.room(); }
  bool effects_full() const noexcept { return effects_.full(); }
  /// The motion `number` is braked on its path as soon as it is the running one, and ends early
  /// (Rest); nothing may be pushed after it before.
  void brake(std::uint32_t number) noexcept { brake_.store(number, std::memory_order_release); }
  /// Nothing more will come: the generator finishes when it has done what is there.
  void close() noexcept { closed_.store(true, std::memory_order_release); }

  // The generator's side. The pointers are null when there is nothing.
  const SegmentDescriptor* next_segment() const noexcept { return segments_.front(); }
  void pop_segment() noexcept { segments_.pop(); }
  const Effect* next_effect() const noexcept { return effects_.front(); }
  void pop_effect() noexcept { effects_.pop(); }
  /// The motion to be braked; 0: none. Taken back once it is done.
  std::uint32_t to_be_braked() const noexcept { return brake_.load(std::memory_order_acquire); }
  void braked() noexcept { brake_.store(0, std::memory_order_relaxed); }
  /// The least t_acc of all segments pushed so far, s; infinite before the first.
  double tightest() const noexcept { return tightest_.load(std::memory_order_relaxed); }
  bool closed() const noexcept { return closed_.load(std::memory_order_acquire); }

 private:
  SpscRing<SegmentDescriptor> segments_;
  SpscRing<Effect> effects_;
  std::atomic<std::uint32_t> brake_{0};
  std::atomic<double> tightest_{std::numeric_limits<double>::infinity()};
  std::atomic<bool> closed_{false};
};

}  // namespace rob::motion
