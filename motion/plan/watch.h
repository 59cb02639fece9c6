#pragma once

#include <cstdint>

#include "motion/space/analog_channels.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

/// What can be seen of the world in one control cycle. SI.
struct CycleView {
  double time = 0;                ///< s, when the cycle begins
  JointVector reference;          ///< where the axes are meant to be at that instant
  JointVector measured;           ///< where they are
  std::uint64_t inputs = 0;       ///< latched in this cycle: bit i is input channel i
  std::uint64_t outputs = 0;      ///< as the last cycle has left them
  AnalogValues analog_inputs{};   ///< V, as inputs
  AnalogValues analog_outputs{};  ///< V, as outputs
};

/// What a Watch says of one cycle.
enum class WatchAnswer : std::uint8_t {
  No,
  Yes,
  Failed  ///< its computation has no result; its owner knows why
};

/// A question that is asked in every control cycle. Motion does not know what it is about. `test`
/// runs in the tick: no memory, no lock, bounded work. `self` belongs to the asker, and stays until
/// the Rest of what is watched has been taken.
struct Watch {
  using Test = WatchAnswer (*)(const void* self, const CycleView& view) noexcept;

  Test test = nullptr;  ///< null: nothing is watched
  const void* self = nullptr;

  bool present() const noexcept { return test != nullptr; }
  WatchAnswer ask(const CycleView& view) const noexcept { return test(self, view); }
};

}  // namespace rob::motion
