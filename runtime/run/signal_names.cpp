#include "runtime/run/signal_names.h"

#include <cassert>
#include <cstdlib>
#include <utility>

#include "lang/values/number_text.h"
#include "lang/values/units.h"
#include "runtime/words/signature.h"

namespace rob::runtime {

SignalNames::SignalNames(const motion::RobotModel& robot,
                         const std::vector<lang::NamedSignal>& named)
    : signature_(signature_of(robot)) {
  for (std::size_t i = 0; i < signature_.signals.size(); ++i) {
    signals_.push_back({.name = lang::shown_name(signature_.signals[i]),
                        .signal = -1,
                        .dimension = lang::kVoltage,
                        .low = 0,
                        .high = lang::kMostVolts});
  }
  for (const lang::NamedSignal& signal : named) {
    lang::NamedSignal& entry = signals_.at(static_cast<std::size_t>(signal.signal));
    if (entry.signal < 0) entry = signal;
  }
}

const lang::NamedSignal& SignalNames::find(bool analog, int channel) const {
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    const lang::RobotSignature::Signal& signal = signature_.signals[i];
    if (signal.output && signal.analog == analog && signal.channel == channel + 1) {
      return signals_[i];
    }
  }
  assert(false && "an effect on a channel that the robot lacks");
  return signals_.front();
}

SignalNames::Quantity SignalNames::quantity(int channel, double volts) const {
  const lang::NamedSignal& signal = find(true, channel);
  const double value = signal.low + volts * ((signal.high - signal.low) / lang::kMostVolts);
  Quantity quantity;
  quantity.unit = lang::unit_text(signal.dimension);
  quantity.text = lang::number_text(value, signal.dimension);
  quantity.number = std::strtod(quantity.text.c_str(), nullptr);
  return quantity;
}

}  // namespace rob::runtime
