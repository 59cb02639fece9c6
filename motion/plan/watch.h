#pragma once

#include <cstdint>

#include "motion/space/analog_channels.h"
#include "motion/space/joint_vector.h"
#include "motion/space/wrench.h"

namespace rob::motion {

/// The view of the world in one control cycle. SI.
struct CycleView {
  double time = 0;                ///< s, when the cycle begins
  JointVector reference;          ///< where the axes are meant to be at that instant
  JointVector measured;           ///< where they are
  std::uint64_t inputs = 0;       ///< latched in this cycle: bit i is input channel i
  std::uint64_t outputs = 0;      ///< as the last cycle has left them
  AnalogValues analog_inputs{};   ///< V, as inputs
  AnalogValues analog_outputs{};  ///< V, as outputs
  Wrench wrench;                  ///< what the world does to the tool, along the world's axes
};

/// The answer of a Watch for one cycle.
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

/// How fast a motion shall be, asked in every control cycle: AT LIVE. As a Watch.
struct LivePace {
  /// The value of the pace; NaN where its computation has no result, and its owner knows why.
  using Value = double (*)(const void* self, const CycleView& view) noexcept;

  Value value = nullptr;  ///< null: the motion keeps its own pace
  const void* self = nullptr;
  double unit_time = 0;  ///< s that the motion takes at a pace of 1; 0: the pace does not bound it

  bool present() const noexcept { return value != nullptr && unit_time > 0; }
  /// 1/s: what share of the motion is done in a second, 0 or above; or NaN.
  double rate(const CycleView& view) const noexcept {
    const double pace = value(self, view);
    return pace < 0 ? 0 : pace / unit_time;
  }
};

}  // namespace rob::motion
