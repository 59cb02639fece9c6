#include "runtime/command/program_effects.h"

#include <string>
#include <utility>

#include "runtime/command/signal_access.h"
#include "runtime/tick/simulated_inputs.h"
#include "runtime/words/force_words.h"

namespace rob::runtime {

using lang::Reply;
using motion::Effect;

namespace {

/// How far the axes of SIMULATE's frame may be beside the world's: 1 − the cosine.
/// [choice] 0.08°
constexpr double kAlongWorld = 1e-6;

}  // namespace

ProgramEffects::ProgramEffects(const RobotLinks& links, EffectQueue& effects, NextMotion& next,
                               Whens& whens, double override_share)
    : links_(links),
      effects_(effects),
      next_(next),
      whens_(whens),
      operators_override_(override_share) {
  links.planner.set_override(override_share);
}

Reply ProgramEffects::queue(const Effect& effect, bool changes) {
  if (next_.takes(effect)) return Reply::Done;
  if (whens_.in_the_making()) return whens_.act(effect);
  const Reply reply = effects_.push(effect, changes);
  if (reply == Reply::Done) links_.log.queued_effect();
  return reply;
}

Reply ProgramEffects::note(int line, Note note) {
  if (full()) return Reply::Later;
  Effect effect;
  effect.tag = static_cast<motion::Tag>(line);
  effect.kind = Effect::Kind::Note;
  const bool printed = note.kind == Note::Kind::Print;
  effect.id = links_.log.keep(std::move(note));
  return queue(effect, !printed);
}

Reply ProgramEffects::write_signal(int line, int signal, bool value) {
  Effect effect = effect_on(links_.signal(signal), line);
  effect.kind = Effect::Kind::Output;
  effect.value = value;
  return queue(effect);
}

Reply ProgramEffects::write_analog(int line, int signal, double volts) {
  Effect effect = effect_on(links_.signal(signal), line);
  effect.kind = Effect::Kind::Analog;
  effect.volts = volts;
  return queue(effect);
}

Reply ProgramEffects::pulse(int line, int signal, double seconds) {
  Effect effect = effect_on(links_.signal(signal), line);
  effect.kind = Effect::Kind::Pulse;
  effect.seconds = seconds;
  return queue(effect);
}

/// Up to 1 it is an effect in motion order, which slows the path's time; above, the planner raises
/// what is commanded from here on.
Reply ProgramEffects::override_speed(int line, double share) {
  if (full()) return Reply::Later;
  Effect effect;
  effect.tag = static_cast<motion::Tag>(line);
  effect.kind = Effect::Kind::Override;
  effect.share = operators_override_ * share;
  const Reply reply = queue(effect);
  if (reply == Reply::Done) links_.planner.set_override(effect.share);
  return reply;
}

Reply ProgramEffects::simulate(int line, int signal, double value, double after) {
  Effect effect = effect_on(links_.signal(signal), line);
  effect.kind =
      links_.signal(signal).analog ? Effect::Kind::SimulateAnalog : Effect::Kind::Simulate;
  effect.value = value != 0;
  effect.volts = value;
  effect.seconds = after;
  return queue_simulation(line, effect);
}

Reply ProgramEffects::simulate_force(int line, int component, const motion::Pose& frame,
                                     double value, double after) {
  const Eigen::Vector3d axis = frame.orientation * Eigen::Vector3d::Unit(component % 3);
  Eigen::Index along = 0;
  if (axis.cwiseAbs().maxCoeff(&along) < 1 - kAlongWorld)
    return links_.refuse(words_for_oblique_force());
  Effect effect;
  effect.kind = Effect::Kind::SimulateForce;
  effect.channel = static_cast<std::uint8_t>(along + (component < 3 ? 0 : 3));
  effect.volts = axis[along] < 0 ? -value : value;
  effect.seconds = after;
  return queue_simulation(line, effect);
}

Reply ProgramEffects::simulate_go(int line, double after) {
  const Reply reply = queue_simulation(line, {.kind = Effect::Kind::SimulateGo, .seconds = after});
  if (reply == Reply::Done) links_.channels.panel.promise_go();
  return reply;
}

Reply ProgramEffects::simulate_answer(int line, std::string_view text, double after) {
  if (full()) return Reply::Later;
  Effect effect{.kind = Effect::Kind::SimulateAnswer, .seconds = after};
  effect.id = links_.channels.panel.promise_answer(std::string(text));
  return queue_simulation(line, effect);
}

Reply ProgramEffects::queue_simulation(int line, Effect effect) {
  const std::int64_t waiting =
      simulations_ - links_.channels.simulations_done.load(std::memory_order_acquire);
  if (waiting >= static_cast<std::int64_t>(SimulatedInputs::kMostWaiting))
    return links_.refuse(words_for_many_simulations());
  effect.tag = static_cast<motion::Tag>(line);
  const Reply reply = queue(effect);
  if (reply == Reply::Done) ++simulations_;
  return reply;
}

}  // namespace rob::runtime
