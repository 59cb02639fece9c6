#include "runtime/tick/inputs.h"

namespace rob::runtime {

namespace {

motion::JointVector six(const motion::Wrench& wrench) noexcept {
  motion::JointVector values(6);
  values << wrench.force, wrench.torque;
  return values;
}

}  // namespace

Inputs::Inputs(const motion::RobotModel& robot, const std::vector<SimulationRule>& script,
               const Outputs& outputs, const ServoHistory& history, Channels& channels)
    : outputs_(outputs),
      history_(history),
      channels_(channels),
      gauge_(robot),
      simulated_(script, channels.panel) {}

void Inputs::prepare(double now) noexcept {
  of_machine_ = channels_.inputs.load(std::memory_order_relaxed);
  analog_of_machine_ = channels_.analog_inputs.load();
  latch(now);
}

void Inputs::take(const ServoSample& sample) noexcept {
  of_machine_ = sample.inputs;
  analog_of_machine_ = sample.analog_inputs;
  gauge_.take(sample);
}

void Inputs::latch(double now) noexcept {
  WorldImage image{of_machine_, outputs_.digital(), analog_of_machine_, outputs_.analog(), {}};
  if (const ServoHistory::Seen* const servo = history_.at(now))
    image.wrench = gauge_.in_world(servo->measured.q);
  simulated_.latch(now, image);
  for (const std::uint32_t line : simulated_.lines()) channels_.device_lines.push(line);
  wrench_ = image.wrench;
  if (gauge_.feels() || simulated_.feels()) channels_.wrench.store(six(wrench_));
  channels_.inputs.store(image.inputs, std::memory_order_relaxed);
  channels_.analog_inputs.store(image.analog_inputs);
  channels_.simulations_done.store(simulated_.simulations_done(), std::memory_order_release);
}

void Inputs::simulate(const SimulatedSetting& setting, double time, double now) noexcept {
  simulated_.schedule(setting, time);  // RobotMachine has counted: there is room
  latch(now);
}

void Inputs::zero_force(double now) noexcept {
  gauge_.zero();
  latch(now);
}

motion::CycleView Inputs::view(double now, const motion::JointVector& reference) const noexcept {
  motion::CycleView view{now,
                         reference,
                         reference,
                         channels_.inputs.load(std::memory_order_relaxed),
                         outputs_.digital(),
                         channels_.analog_inputs.load(),
                         outputs_.analog(),
                         wrench_};
  if (const ServoHistory::Seen* const servo = history_.at(now))
    view.measured = servo->measured.q + servo->measured.qd * (now - servo->measured.time);
  return view;
}

}  // namespace rob::runtime
