#pragma once

#include <atomic>
#include <cstdint>

#include "motion/plan/segment_descriptor.h"
#include "motion/plan/watch.h"

namespace rob::motion {

/// What is done whenever a condition comes true: WHEN. The program's thread sets it up and sends an
/// effect that arms it, later one that disarms it; from the one to the other it is the tick's.
struct WatchedAction {
  enum class Kind : std::uint8_t {
    Act,   ///< the effect acts in the cycle
    Raise  ///< the axes brake, and all that was commanded is dropped (Rest::by)
  };

  Watch condition;
  Kind kind = Kind::Act;
  Effect effect;  ///< of Act
  Tag tag = 0;

  /// It may not be set up anew while it is armed, nor before the Rest that it caused is taken.
  std::atomic<bool> armed{false};
  std::atomic<bool> fired{false};
};

}  // namespace rob::motion
