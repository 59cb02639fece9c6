#pragma once

#include <cstdint>
#include <vector>

#include "motion/robots/robot_model.h"
#include "runtime/tick/channels.h"
#include "runtime/tick/force_gauge.h"
#include "runtime/tick/outputs.h"
#include "runtime/tick/servo_history.h"
#include "runtime/tick/simulated_inputs.h"

namespace rob::runtime {

/// The world as the program sees it in one cycle: the inputs and the force as the machine says,
/// and what is simulated in their place. Every call but the constructor may be used in the tick;
/// `now`: of the current cycle, s.
class Inputs {
 public:
  Inputs(const motion::RobotModel& robot, const std::vector<SimulationRule>& script,
         const Outputs& outputs, const ServoHistory& history, Channels& channels);

  /// The values that the machine had when it was enabled are there until the first sample.
  void prepare(double now) noexcept;
  void take(const ServoSample& sample) noexcept;
  /// From here on the program sees what is known now.
  void latch(double now) noexcept;
  /// From `time` on, s; what holds now is seen in this cycle already.
  void simulate(const SimulatedSetting& setting, double time, double now) noexcept;
  void zero_force(double now) noexcept;

  /// The values that the watches look at; `reference`: of this cycle.
  motion::CycleView view(double now, const motion::JointVector& reference) const noexcept;
  /// Along the world.
  const motion::Wrench& wrench() const noexcept { return wrench_; }
  const ForceGauge& gauge() const noexcept { return gauge_; }
  ScriptedOperator& scripted_operator() noexcept { return simulated_.scripted_operator(); }

 private:
  const Outputs& outputs_;
  const ServoHistory& history_;
  Channels& channels_;
  std::uint64_t of_machine_ = 0;
  motion::AnalogValues analog_of_machine_{};
  ForceGauge gauge_;
  SimulatedInputs simulated_;
  motion::Wrench wrench_;
};

}  // namespace rob::runtime
