#include <algorithm>
#include <span>

#include "runtime/command/robot_machine.h"

/// Member functions of RobotMachine for SAFE: the values of outputs after a run has failed.
namespace rob::runtime {

using lang::Reply;
using motion::Effect;

void RobotMachine::declare_safe(const std::vector<lang::SafeValue>& values) {
  channels_.safe.clear();
  declare_safe_behind(values);
}

void RobotMachine::declare_safe_behind(std::span<const lang::SafeValue> values) {
  for (const lang::SafeValue& declared :
       values.subspan(std::min(values.size(), channels_.safe.size()))) {
    Effect effect = effect_on(declared.line, declared.signal);
    const bool analog = signals_.at(static_cast<std::size_t>(declared.signal)).analog;
    effect.kind = analog ? Effect::Kind::Analog : Effect::Kind::Output;
    effect.value = declared.value != 0;
    effect.volts = declared.value;
    effect.safe = true;
    channels_.safe.add(effect);
  }
}

Reply RobotMachine::fail(int line) {
  bar_handlers(true);
  if (collecting()) drop_path();
  if (channels_.safe.empty() && handler_ != Handler::HasAxes) return end(line);
  take_interruption();  // the first error is the one to mend
  const Reply reply = settle(line);
  if (reply != Reply::Done) return reply;
  bar_handlers(true);
  if (take_safe_values() != Reply::Done) return Reply::Later;
  return end(line);
}

/// For good, but for a robot that stays under control.
Reply RobotMachine::take_safe_values() {
  for (; safe_queued_ < channels_.safe.size(); ++safe_queued_) {
    Effect effect = channels_.safe[safe_queued_];
    effect.safe = !stays_;
    if (queue(effect) != Reply::Done) return Reply::Later;
  }
  if (stays_) safe_queued_ = 0;
  return Reply::Done;
}

}  // namespace rob::runtime
