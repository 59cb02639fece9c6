#pragma once

#include <array>
#include <cstddef>

#include "motion/space/joint_vector.h"

namespace rob::motion {

/// The references of the last servo cycles, for what is measured later than it was commanded: a
/// machine on a wire answers for an instant that has passed. Every call may be used in the tick.
class ReferenceHistory {
 public:
  /// Forgets what was before `first`.
  void reset(const JointReference& first) noexcept;
  void push(const JointReference& reference) noexcept;
  /// The newest reference itself from its time on, the oldest that is kept before; between two
  /// neighbours on the straight line between them.
  JointReference at(double time) const noexcept;

 private:
  /// [choice] 1.2 s at 20 ms: longer than any machine may be silent.
  static constexpr std::size_t kKept = 64;

  const JointReference& back(std::size_t i) const noexcept {
    return ring_[(pushed_ - 1 - i) % kKept];
  }

  std::array<JointReference, kKept> ring_;
  std::size_t pushed_ = 0;
};

}  // namespace rob::motion
