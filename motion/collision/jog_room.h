#pragma once

#include <array>
#include <atomic>
#include <limits>

#include "motion/space/joint_vector.h"
#include "motion/space/spsc_ring.h"

namespace rob::motion {

/// How far a jog may go before bodies come near each other. A thread of its own measures the
/// distances at a place of the axes and hands them over; the tick measures nothing: it takes off
/// what the axes have gone since, times the levers of each pair.
///
/// A pair may come as near as kKept. A pair that is nearer already may part: for kTrusted around
/// the measured place the slopes of its distance say whether it does. A view older than kOld
/// counts as no room.
class JogRoom {
 public:
  static constexpr int kNear = 12;          // [choice] pairs that are looked at one by one
  static constexpr double kKept = 5e-3;     // m
  static constexpr double kTrusted = 2e-3;  // m [choice] of the way of a body
  static constexpr double kLeast = 1e-3;    // m [choice] that slopes alone never go below
  static constexpr double kOld = 0.05;      // s

  /// stops() returns the number of a pair, or one of these.
  static constexpr int kFree = -1;
  static constexpr int kUnknown = -2;  ///< nothing has been measured lately
  static constexpr int kOther = -3;    ///< a pair that is not among the nearest

  /// A pair where it was measured.
  struct Near {
    int pair = 0;
    double distance = 0;  ///< m
    JointVector levers;   ///< m by which it comes nearer at most, per m or rad of each axis
    JointVector up;       ///< by how much it parts where an axis goes up, per m or rad
    JointVector down;     ///< where it goes down
  };
  struct View {
    double time = 0;  ///< s
    JointVector q;    ///< where it was measured
    int count = 0;
    std::array<Near, kNear> near;
    double others = std::numeric_limits<double>::infinity();  ///< m: no other pair is nearer
    JointVector levers;                                       ///< the greatest of all pairs
  };

  /// Before the run: there are pairs.
  void use() noexcept { used_ = true; }
  bool used() const noexcept { return used_; }
  /// A jog comes: from here on distances are wanted. From any thread.
  void want() noexcept { wanted_.store(true, std::memory_order_relaxed); }

  // The thread that measures.
  bool wanted() const noexcept { return used_ && wanted_.load(std::memory_order_relaxed); }
  void publish(const View& view) noexcept { views_.push(view); }

  // The tick.
  /// Takes the latest view; `now`: s.
  void look(double now) noexcept;
  /// The pair that keeps the axes from being there; kFree: none does.
  int stops(const JointVector& q) const noexcept;

 private:
  static bool may(const Near& near, const JointVector& way) noexcept;

  bool used_ = false;
  std::atomic<bool> wanted_{false};
  SpscRing<View> views_{4};
  double now_ = 0;
};

}  // namespace rob::motion
