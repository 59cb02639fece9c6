#include "runtime/command/force_commands.h"

#include <cmath>

#include "runtime/tick/force_gauge.h"
#include "runtime/words/force_words.h"

namespace rob::runtime {

using lang::Reply;
using State = PressLine::State;

namespace {

/// A force must be at least this many times the noise of the sensor. [choice] the sensor cannot
/// distinguish a smaller one from none
constexpr double kResolved = 5;

std::optional<Words> words_against(const lang::PressCommand& command,
                                   const motion::RobotModel& robot) {
  const double force = std::abs(command.force);
  const double least = kResolved * robot.force.noise;
  if (command.force == 0 || force < least) return words_for_press_of_nothing(least);
  if (robot.force.limit > 0 && force >= robot.force.limit)
    return words_for_press_too_hard(command.force, robot.force.limit);
  return std::nullopt;
}

}  // namespace

Reply ForceCommands::zero_force(int line) {
  if (press_.state() == State::Yes) return links_.refuse(words_for_zero_in_press());
  if (effects_.full()) return Reply::Later;
  const Reply reply = queue_.dwell_alone(line, ForceGauge::kZeroing);
  if (reply != Reply::Done) return reply;
  motion::Effect effect;
  effect.tag = static_cast<motion::Tag>(line);
  effect.kind = motion::Effect::Kind::ZeroForce;
  return effects_.queue(effect);
}

Reply ForceCommands::press(int line, const lang::PressCommand& command) {
  if (press_.state() == State::Yes) return links_.refuse(words_for_press_in_press());
  if (press_.state() == State::No) {
    if (const Reply reply = begin_press(line, command); reply != Reply::Done) return reply;
  }
  if (press_.state() != State::Seeking) return leave_press(false);
  const PressDesk::State desk = links_.channels.press.state.load(std::memory_order_acquire);
  if (desk == PressDesk::State::Lost || desk == PressDesk::State::AtEnd) press_.ask_to_end();
  if (desk != PressDesk::State::Keeping || progress_.interrupted()) return Reply::Later;
  press_.keep();
  return Reply::Done;
}

Reply ForceCommands::begin_press(int line, const lang::PressCommand& command) {
  if (links_.of_handlers()) return links_.refuse(words_for_press_in_handler());
  if (auto words = words_against(command, links_.robot)) return links_.refuse(std::move(*words));
  if (const Reply reply = queue_.dwell_alone(line, 0); reply != Reply::Done)
    return reply;  // a mark
  if (!progress_.settled()) return Reply::Later;
  press_.seek({surroundings_.frame().orientation * Eigen::Vector3d::Unit(command.axis),
               command.force, command.limit});
  return Reply::Done;
}

Reply ForceCommands::end_press(int line) {
  if (press_.state() == State::Yes) {
    if (const Reply reply = queue_.stop(line); reply != Reply::Done) return reply;
    if (!progress_.stands()) return Reply::Later;
    press_.ask_to_end();
  }
  return leave_press(true);
}

/// One that has not come to its force yet is not the block's; its error is the one that is settled.
Reply ForceCommands::give_up_press() {
  if (press_.state() == State::Seeking) press_.ask_to_end();
  if (press_.state() == State::No || press_.state() == State::Yes) return Reply::Done;
  return leave_press(true) == Reply::Later ? Reply::Later : Reply::Done;
}

/// The path goes on from where the axes have come to stand. `met`: what is lost had been met.
Reply ForceCommands::leave_press(bool met) {
  if (links_.channels.press.state.load(std::memory_order_acquire) != PressDesk::State::Off)
    return Reply::Later;
  queue_.restart_from(links_.channels.joints.load());
  const State ended = press_.leave();
  if (ended == State::EndingAtEnd) return links_.refuse(words_for_press_at_end(met));
  return ended == State::EndingLost
             ? links_.refuse(words_for_no_contact(motion::Press::kReach, met))
             : Reply::Done;
}

}  // namespace rob::runtime
