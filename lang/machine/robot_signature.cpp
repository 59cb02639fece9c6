#include "lang/machine/robot_signature.h"

#include <fmt/core.h>

namespace rob::lang {

std::string shown_name(const RobotSignature::Signal& signal) {
  if (!signal.name.empty()) return signal.name;
  return fmt::format("{}[{}]", channel_word(signal.output, signal.analog), signal.channel);
}

}  // namespace rob::lang
