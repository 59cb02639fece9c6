#include "runtime/command/safe_outputs.h"

#include <algorithm>

#include "runtime/command/signal_access.h"

namespace rob::runtime {

using lang::Reply;
using motion::Effect;

void SafeOutputs::declare(std::span<const lang::SafeValue> values) {
  links_.channels.safe.clear();
  declare_further(values);
}

void SafeOutputs::declare_further(std::span<const lang::SafeValue> values) {
  SafeValues& safe = links_.channels.safe;
  for (const lang::SafeValue& declared : values.subspan(std::min(values.size(), safe.size()))) {
    const lang::RobotSignature::Signal& signal = links_.signal(declared.signal);
    Effect effect = effect_on(signal, declared.line);
    effect.kind = signal.analog ? Effect::Kind::Analog : Effect::Kind::Output;
    effect.value = declared.value != 0;
    effect.volts = declared.value;
    effect.safe = true;
    safe.add(effect);
  }
}

Reply SafeOutputs::take(bool stays) {
  for (; queued_ < links_.channels.safe.size(); ++queued_) {
    Effect effect = links_.channels.safe[queued_];
    effect.safe = !stays;
    if (effects_.queue(effect) != Reply::Done) return Reply::Later;
  }
  if (stays) queued_ = 0;
  return Reply::Done;
}

}  // namespace rob::runtime
