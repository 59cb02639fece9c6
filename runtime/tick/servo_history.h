#pragma once

#include <array>
#include <cstddef>

#include "runtime/tick/channels.h"

namespace rob::runtime {

/// The servo's last samples: what was measured at the stamp of a reference is looked up here. Every
/// call may be used in the tick.
class ServoHistory {
 public:
  /// The part of a ServoSample that is kept.
  struct Seen {
    motion::JointMeasurement measured;
    motion::JointVector drive;
    bool settled = true;
    bool joining = false;
  };

  void take(const ServoSample& sample) noexcept;
  /// The measurement of `stamp`, s; null before the first servo cycle.
  const Seen* at(double stamp) const noexcept;
  /// Null before the first servo cycle.
  const Seen* newest() const noexcept;
  /// Puts in what was measured at the stamp of the snapshot's reference; before the first servo
  /// cycle, the reference itself.
  void put_into(Snapshot& snapshot) const noexcept;

  /// Greatest demanded force / what the drive can give, since it was taken last.
  double saturation() const noexcept { return saturation_; }
  double take_saturation() noexcept;

 private:
  static constexpr std::size_t kKept = 64;

  std::array<Seen, kKept> kept_;
  std::size_t taken_ = 0;  ///< so far; the newest is at (taken_ − 1) % kKept
  double saturation_ = 0;
};

}  // namespace rob::runtime
