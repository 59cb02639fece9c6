#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "motion/ahead/piece.h"
#include "motion/plan/segment_descriptor.h"
#include "motion/space/spsc_ring.h"

namespace rob::motion {

/// A motion on the path, or what stands between two: σ at which it begins and ends. A stop, a
/// dwell, a jog and a motion with a profile have no way on it, and the path comes to rest at them.
struct PathLeg {
  SegmentDescriptor segment;
  double begin = 0;
  double end = 0;
  double decides = 0;  ///< σ by which the next motion must be known (motion.md: decision point)
  int average = 1;     ///< periods of the mean that makes the references of its run
  bool pauses =
      false;  ///< all legs of its run end at rest, so the run has the shorter mean (Guide)
  bool of_sigma = false;  ///< the mean averages σ; otherwise it averages the axes
  /// m at its beginning, and at its end, where σ is the motion's way. Between them, on a curve
  /// along several motions, what a m of σ is of the way is not the same everywhere.
  double before = 0;
  double beyond = 0;

  /// The way on the motion, m, that belongs to σ, m from its beginning; on a curve its mean course.
  double way(double sigma) const noexcept {
    return sigma <= before        ? sigma
           : sigma >= curve_end() ? segment.ahead.length - (end - begin - sigma)
                                  : before + (sigma - before) * slope(sigma);
  }
  /// Its derivative.
  double slope(double sigma) const noexcept {
    if (sigma < before || sigma >= curve_end()) return 1;
    return (segment.ahead.length - before - beyond) / (curve_end() - before);
  }
  double curve_end() const noexcept { return end - begin - beyond; }
};

/// The path between its planner (one writer) and the tick (one reader): pieces, and beside them the
/// motions they belong to. Memory is taken by the constructor alone; nothing locks or waits.
///
/// At the end of each piece stands the greatest σ'² from which the standstill at the end of what is
/// known can still be reached: 0 at the very end. The planner raises it as path is appended, from
/// the end backwards, so that a value that the reader sees is as good as all after it.
///
/// Path that ends early is dropped: the reader asks, the planner forgets all it has taken from the
/// LookAheadBuffer and empties that, and says so; what it has written before then is passed over.
class PathRing {
 public:
  using Index = std::uint64_t;  ///< of a piece, counted from the start

  /// For no fewer pieces than that: a power of two.
  PathRing(std::size_t pieces, std::size_t legs) : slots_(std::bit_ceil(pieces)), legs_(legs) {}

  // The planner's side.
  std::size_t room() const noexcept {
    return slots_.size() - static_cast<std::size_t>(tail_.load(std::memory_order_relaxed) -
                                                    head_.load(std::memory_order_acquire));
  }
  std::size_t capacity() const noexcept { return slots_.size(); }
  std::size_t leg_room() const noexcept { return legs_.room(); }
  std::size_t leg_capacity() const noexcept { return legs_.capacity(); }
  Index end() const noexcept { return tail_.load(std::memory_order_relaxed); }
  Index begin() const noexcept { return head_.load(std::memory_order_acquire); }
  /// A piece after the published ones; there must be room.
  Piece& draft(Index at) noexcept { return slot(at).piece; }
  const Piece& written(Index at) const noexcept { return slot(at).piece; }
  void set_square(Index at, double square) noexcept {
    slot(at).square.store(square, std::memory_order_release);
  }
  /// Whether the square is so small only since nothing is known after the last piece.
  void set_cut(Index at, bool is) noexcept { slot(at).cut.store(is, std::memory_order_relaxed); }
  void set_run_end(Index at, bool is) noexcept {
    slot(at).run_end.store(is, std::memory_order_release);
  }
  /// All drafts before `end` are pieces from here on.
  void publish(Index end) noexcept { tail_.store(end, std::memory_order_release); }
  bool push(const PathLeg& leg) noexcept { return legs_.push(leg); }
  bool drop_asked() const noexcept {
    return asked_.load(std::memory_order_acquire) != done_.load(std::memory_order_relaxed);
  }
  /// Generations up to this one are over.
  std::uint32_t over() const noexcept { return over_.load(std::memory_order_relaxed); }
  /// `number`: of the last motion taken from the buffer.
  void dropped(std::uint32_t number, std::uint32_t generation) noexcept {
    last_number_ = number;
    last_generation_ = generation;
    done_.store(asked_.load(std::memory_order_relaxed), std::memory_order_release);
  }

  // The tick's side.
  /// Null where the path is not known yet.
  const Piece* piece(Index at) const noexcept {
    return at < tail_.load(std::memory_order_acquire) ? &slot(at).piece : nullptr;
  }
  double square(Index at) const noexcept { return slot(at).square.load(std::memory_order_acquire); }
  bool cut(Index at) const noexcept { return slot(at).cut.load(std::memory_order_relaxed); }
  /// Whether the path comes to rest at the end of the piece, as planned.
  bool run_end(Index at) const noexcept { return slot(at).run_end.load(std::memory_order_acquire); }
  /// Pieces before `at` are not looked at any more.
  void release(Index at) noexcept { head_.store(at, std::memory_order_release); }
  const PathLeg* next_leg() const noexcept { return legs_.front(); }
  /// The i-th after next_leg(), which is the 0th; null: not known yet.
  const PathLeg* leg(std::size_t i) const noexcept { return legs_.at(i); }
  void pop_leg() noexcept { legs_.pop(); }
  /// `generation`: nothing of it, nor of those before, is path any more, even if it comes late.
  void ask_drop(std::uint32_t generation) noexcept {
    over_.store(generation, std::memory_order_relaxed);
    asked_.fetch_add(1, std::memory_order_release);
  }
  /// Then nothing comes any more that was commanded before; see skip_dropped().
  bool drop_done() const noexcept {
    return done_.load(std::memory_order_acquire) == asked_.load(std::memory_order_relaxed);
  }
  /// Passes over all that is here; returns the index at which new path will begin.
  Index skip_dropped() noexcept {
    while (legs_.front() != nullptr) legs_.pop();
    const Index at = tail_.load(std::memory_order_acquire);
    release(at);
    return at;
  }
  std::uint32_t last_number() const noexcept { return last_number_; }
  std::uint32_t last_generation() const noexcept { return last_generation_; }

  // All that each must know of the other, and asks no more often than it works.
  std::atomic<std::uint32_t> late{0};     ///< how often nothing was known of what follows in time
  std::atomic<bool> closed{false};        ///< all that was commanded is here, and no more will come
  std::atomic<double> share{1};           ///< the override
  std::atomic<double> sigma{0};           ///< where the guide is
  std::atomic<double> rate{0};            ///< its σ'
  std::atomic<std::uint64_t> periods{0};  ///< reference periods since the start

 private:
  struct Slot {
    Piece piece;
    std::atomic<double> square{0};
    std::atomic<bool> run_end{false};
    std::atomic<bool> cut{false};
  };
  std::size_t place(Index at) const noexcept {
    return static_cast<std::size_t>(at) & (slots_.size() - 1);
  }
  Slot& slot(Index at) noexcept { return slots_[place(at)]; }
  const Slot& slot(Index at) const noexcept { return slots_[place(at)]; }

  std::vector<Slot> slots_;
  SpscRing<PathLeg> legs_;
  alignas(64) std::atomic<Index> head_{0};
  alignas(64) std::atomic<Index> tail_{0};
  alignas(64) std::atomic<std::uint32_t> asked_{0};
  std::atomic<std::uint32_t> done_{0};
  std::atomic<std::uint32_t> over_{0};
  std::uint32_t last_number_ = 0;  ///< written before done_
  std::uint32_t last_generation_ = 0;
};

}  // namespace rob::motion
