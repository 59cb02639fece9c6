#pragma once

#include "motion/plan/segment_descriptor.h"
#include "runtime/tick/channels.h"
#include "runtime/tick/inputs.h"
#include "runtime/tick/outputs.h"
#include "runtime/tick/speed_share.h"

namespace rob::runtime {

/// Carries out the effects of a program. Every call may be used in the tick; `now`: of the present
/// cycle, in which they act, s.
class Effects {
 public:
  Effects(Outputs& outputs, Inputs& inputs, SpeedShare& speed, Channels& channels) noexcept
      : outputs_(outputs), inputs_(inputs), speed_(speed), channels_(channels) {}

  void act(const motion::Effect& effect, double now) noexcept;
  bool locked(const motion::Effect& effect) const noexcept { return outputs_.locked(effect); }
  /// All that TASKs have done in the cycle before; `dropped`: it does not act.
  void take_immediate(double now, bool dropped) noexcept;
  void take_safe_values(double now) noexcept;
  /// Switches off what was on for a PULSE that is over at `until`, s.
  void end_pulses(double until, double now) noexcept;

 private:
  void simulate(const motion::Effect& effect, double now) noexcept;

  Outputs& outputs_;
  Inputs& inputs_;
  SpeedShare& speed_;
  Channels& channels_;
};

}  // namespace rob::runtime
