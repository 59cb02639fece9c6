#include "runtime/command/robot_machine.h"
#include "runtime/words/codes.h"

/// Member functions of RobotMachine that only a person at a prompt uses.
namespace rob::runtime {

using lang::Reply;
using motion::WatchAnswer;

void RobotMachine::stay() {
  stays_ = true;
  stopping_.condition = {[](const void* self, const motion::CycleView&) noexcept {
                           const auto* const asked = static_cast<const std::atomic<bool>*>(self);
                           return asked->load(std::memory_order_relaxed) ? WatchAnswer::Yes
                                                                         : WatchAnswer::No;
                         },
                         &channels_.stop_requested};
  stopping_.kind = motion::WatchedAction::Kind::Raise;
  stopping_.armed.store(true, std::memory_order_relaxed);
  motion::Effect effect;
  effect.kind = motion::Effect::Kind::Arm;
  effect.watched = &stopping_;
  push(effect);  // the buffer is empty
}

/// The next request is one of its own.
lang::RuntimeError RobotMachine::stopped() {
  stopping_.fired.store(false, std::memory_order_relaxed);
  channels_.stop_requested.store(false, std::memory_order_relaxed);
  lang::RuntimeError error;
  error.code = code::kStopped;
  error.message = "stopped by the operator";
  return error;
}

void RobotMachine::take_place() {
  if (channels_.way_back.moved.exchange(false)) restart_from(channels_.joints.load());
}

/// What a program has armed ends with it.
bool RobotMachine::disarm_all(int line) {
  while (motion::WatchedAction* const armed = whens_.first_in_use()) {
    motion::Effect effect;
    effect.tag = static_cast<motion::Tag>(line);
    effect.kind = motion::Effect::Kind::Disarm;
    effect.watched = armed;
    if (push(effect) != Reply::Done) return false;
    armed->retired.store(true, std::memory_order_relaxed);
    --armed_;
  }
  return true;
}

Reply RobotMachine::jog_while(int line, const lang::MoveCommand& command,
                              const motion::Watch& held) {
  held_ = held;
  guarded_ = true;
  const Reply reply = jog(line, command);
  guarded_ = reply == Reply::Done;
  held_ = {};
  return reply;
}

}  // namespace rob::runtime
