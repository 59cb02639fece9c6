#pragma once

#include <cstdint>

#include "motion/plan/motion_request.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

struct WatchedAction;

/// How what had been commanded came to rest, for the program that waits for it. Where it ended
/// early, all that was commanded in its generation is dropped, and the next motion starts at `q`.
struct Rest {
  enum class Outcome : std::uint8_t {
    Reached,  ///< a guarded motion has arrived at its target
    Hit,      ///< its condition held
    Failed,   ///< its condition could not be computed
    Raised,   ///< a WHEN has raised an error
    Braked,   ///< by request: LookAheadBuffer::brake(), TrajectoryGenerator::leave_path()
    Handled   ///< nothing has ended: the handler of a WHEN begins; the axes stand, but for a Call
  };

  Outcome outcome = Outcome::Reached;
  std::uint32_t generation = 0;
  std::uint32_t number = 0;     ///< of the motion that ran when it happened
  Tag tag = 0;                  ///< of the motion that ran when it happened
  double time = 0;              ///< s, when the axes came to rest
  double trip_time = 0;         ///< s, when the braking began; without braking: time
  WatchedAction* by = nullptr;  ///< the WHEN that caused it or could not be computed; else null
  JointVector q;                ///< m, rad: the reference at rest
  JointVector trip_q;           ///< what was measured in the cycle in which the braking began

  bool early() const noexcept { return outcome != Outcome::Reached; }
  /// It ends what was commanded, since a WHEN says so.
  bool failure() const noexcept { return by != nullptr && outcome != Outcome::Handled; }
};

}  // namespace rob::motion
