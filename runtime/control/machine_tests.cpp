#include <string>

#include "runtime/control/messages.h"
#include "runtime/control/robot_machine.h"
#include "runtime/control/simulated_inputs.h"

/// The part of RobotMachine that knows what only a TEST does: EXPECT and SIMULATE.
namespace rob::runtime {

using lang::Reply;

Reply RobotMachine::expectation_failed(int line, std::string_view text) {
  log_.expect_failed({line, std::string(text)});
  return Reply::Done;
}

Reply RobotMachine::simulate(int line, int signal, double value, double after) {
  motion::Effect effect = effect_on(line, signal);
  const bool analog = signals_[static_cast<std::size_t>(signal)].analog;
  effect.kind = analog ? motion::Effect::Kind::SimulateAnalog : motion::Effect::Kind::Simulate;
  effect.value = value != 0;
  effect.volts = value;
  effect.seconds = after;
  return queue_simulation(line, effect);
}

Reply RobotMachine::queue_simulation(int line, motion::Effect effect) {
  const std::int64_t waiting =
      simulations_ - channels_.simulations_done.load(std::memory_order_acquire);
  if (waiting >= static_cast<std::int64_t>(SimulatedInputs::kMostWaiting)) {
    refusal_ = words_for_many_simulations();
    return Reply::Refused;
  }
  effect.tag = static_cast<motion::Tag>(line);
  const Reply reply = queue(effect);
  if (reply == Reply::Done) ++simulations_;
  return reply;
}

}  // namespace rob::runtime
