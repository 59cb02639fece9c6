#include "runtime/command/operator_stop.h"

#include "runtime/words/codes.h"

namespace rob::runtime {

using motion::WatchAnswer;

void OperatorStop::stay() {
  stays_ = true;
  stopping_.condition = {[](const void* self, const motion::CycleView&) noexcept {
                           const auto* const asked = static_cast<const std::atomic<bool>*>(self);
                           return asked->load(std::memory_order_relaxed) ? WatchAnswer::Yes
                                                                         : WatchAnswer::No;
                         },
                         &links_.channels.stop_requested};
  stopping_.kind = motion::WatchedAction::Kind::Raise;
  stopping_.armed.store(true, std::memory_order_relaxed);
  motion::Effect effect;
  effect.kind = motion::Effect::Kind::Arm;
  effect.watched = &stopping_;
  effects_.push(effect);  // the buffer is empty
}

lang::RuntimeError OperatorStop::take_error() {
  stopping_.fired.store(false, std::memory_order_relaxed);
  links_.channels.stop_requested.store(false, std::memory_order_relaxed);
  lang::RuntimeError error;
  error.code = code::kStopped;
  error.message = "stopped by the operator";
  return error;
}

}  // namespace rob::runtime
