#include <string>

#include "runtime/command/robot_machine.h"
#include "runtime/tick/simulated_inputs.h"
#include "runtime/words/messages.h"

/// Member functions of RobotMachine that only a TEST uses: EXPECT and SIMULATE.
namespace rob::runtime {

using lang::Reply;
using motion::Effect;

Reply RobotMachine::expectation_failed(int line, std::string_view text) {
  log_.expect_failed({line, std::string(text)});
  return Reply::Done;
}

Reply RobotMachine::simulate(int line, int signal, double value, double after) {
  Effect effect = effect_on(line, signal);
  const bool analog = signals_[static_cast<std::size_t>(signal)].analog;
  effect.kind = analog ? Effect::Kind::SimulateAnalog : Effect::Kind::Simulate;
  effect.value = value != 0;
  effect.volts = value;
  effect.seconds = after;
  return queue_simulation(line, effect);
}

Reply RobotMachine::queue_simulation(int line, Effect effect) {
  const std::int64_t waiting =
      simulations_ - channels_.simulations_done.load(std::memory_order_acquire);
  if (waiting >= static_cast<std::int64_t>(SimulatedInputs::kMostWaiting)) {
    refuse(words_for_many_simulations());
    return Reply::Refused;
  }
  effect.tag = static_cast<motion::Tag>(line);
  const Reply reply = queue(effect);
  if (reply == Reply::Done) ++simulations_;
  return reply;
}

Reply RobotMachine::simulate_go(int line, bool go, double after) {
  if (!go) return Reply::Done;
  const Reply reply = queue_simulation(line, {.kind = Effect::Kind::SimulateGo, .seconds = after});
  if (reply == Reply::Done) channels_.panel.promise_go();
  return reply;
}

Reply RobotMachine::simulate_answer(int line, std::string_view text, double after) {
  if (buffer_.effects_full()) return Reply::Later;
  Effect effect{.kind = Effect::Kind::SimulateAnswer, .seconds = after};
  effect.id = channels_.panel.promise_answer(std::string(text));
  return queue_simulation(line, effect);
}

}  // namespace rob::runtime
