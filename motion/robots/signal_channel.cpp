#include "motion/robots/signal_channel.h"

#include <algorithm>
#include <vector>

namespace rob::motion {

int signal_channel(const TableReader& table, std::string_view key, bool output,
                   const RobotModel& robot) {
  std::vector<std::string_view> names;
  for (const RobotSignal& signal : robot.signals)
    if (signal.output == output) names.push_back(signal.name);
  const auto wanted = static_cast<std::size_t>(table.choice(key, names));
  const auto found = std::find_if(robot.signals.begin(), robot.signals.end(),
                                  [&](const RobotSignal& s) { return s.name == names[wanted]; });
  return found->channel;
}

}  // namespace rob::motion
