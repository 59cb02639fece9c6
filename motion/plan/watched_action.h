#pragma once

#include <atomic>
#include <cstdint>

#include "motion/plan/segment_descriptor.h"
#include "motion/plan/watch.h"

namespace rob::motion {

/// An action that is done whenever a condition comes true: WHEN. The program's thread sets it up
/// and sends an effect that arms it, later one that disarms it; from the one to the other it is the
/// tick's.
struct WatchedAction {
  enum class Kind : std::uint8_t {
    Act,     ///< the effect acts in the cycle
    Raise,   ///< the axes brake, and all that was commanded is dropped (Rest::by)
    Handle,  ///< the axes stop on their path, and a handler has them (TrajectoryGenerator::go_on())
    Call     ///< a handler is called, and the axes go on
  };

  /// By a handler, of which there is one at a time.
  bool handled() const noexcept { return kind == Kind::Handle || kind == Kind::Call; }

  Watch condition;
  Kind kind = Kind::Act;
  Effect effect;  ///< of Act
  Tag tag = 0;

  /// It may not be set up anew while it is armed, nor before the Rest that it caused is taken.
  std::atomic<bool> armed{false};
  std::atomic<bool> fired{false};
  /// The program has left the block of a handler: it does not begin any more.
  std::atomic<bool> retired{false};
};

}  // namespace rob::motion
