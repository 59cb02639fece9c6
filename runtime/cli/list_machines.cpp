#include "runtime/cli/list_machines.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/split_mix.h"
#include "drivers/serial/port_list.h"
#include "motion/plan/capability.h"
#include "motion/robots/robot_library.h"
#include "runtime/run/console.h"
#include "runtime/run/load.h"
#include "runtime/words/path_words.h"
#include "runtime/words/units.h"

namespace rob::runtime {

namespace {

std::string describe(const motion::RobotModel& robot) {
  std::string text = fmt::format("{}: {}\n", robot.name, robot.description);
  for (const motion::Axis& axis : robot.axes) {
    text += fmt::format("    {:<8} {} … {}, {}/s\n", axis.name, shown(axis.min, axis.kind),
                        shown(axis.max, axis.kind), shown(axis.v_max, axis.kind));
  }
  std::string signals;
  for (const motion::RobotSignal& signal : robot.signals) {
    signals += fmt::format(" {} ({})", signal.name, signal.output ? "output" : "input");
  }
  text += signals.empty() ? "" : "    signals:" + signals + "\n";
  if (robot.force_sensor) text += "    measures forces and torques on its tool\n";
  const char* const laws = motion::can(robot, motion::Law::Paul)
                               ? "Paul's law and the look-ahead law"
                               : "the look-ahead law";
  const char* const motions =
      robot.kinematics->inverts() ? "MOVE, MOVEL, MOVEC, MOVES, SPIRAL, JOG" : "MOVE, JOG JOINT";
  return text + fmt::format("    {} under {}; simulated\n", motions, laws);
}

/// mm: the greatest distance of the flange from the origin of the base that was found. [choice]
/// 20,000 postures, the same each time, come within some percent.
double reach_of(const motion::RobotModel& robot) {
  constexpr int kPostures = 20000;
  SplitMix random(1);
  double reach = 0;
  motion::JointVector q(robot.axis_count());
  for (int i = 0; i < kPostures; ++i) {
    for (int axis = 0; axis < robot.axis_count(); ++axis) {
      const motion::Axis& of = axis_of(robot, axis);
      q[axis] = of.min + (of.max - of.min) * random.share();
    }
    reach = std::max(reach, robot.kinematics->forward(q).position.norm());
  }
  return reach * kMillimetresPerMetre;
}

std::string describe_more(const motion::RobotModel& robot) {
  constexpr double kNearStart = 0.1;  // rad [choice] as messages about paths
  std::string text = fmt::format("    starts at {}\n", axes_text(robot, robot.start));
  text += fmt::format("    its flange gets up to {:.0f} mm from the origin of its base\n",
                      reach_of(robot));
  const motion::SingularPlace place =
      robot.kinematics->nearest_singularity(robot.start, kNearStart);
  if (place != motion::SingularPlace::None)
    text += fmt::format("    its start is near a singular posture: {}; choose another start\n",
                        words_for(place));
  return text;
}

}  // namespace

ExitCode list_ports() {
  const std::vector<drivers::PortEntry> ports = drivers::list_ports();
  for (const drivers::PortEntry& port : ports) {
    put_result(fmt::format("{}: {}\n", port.path, port.state));
    if (!port.by_id.empty()) put_result(fmt::format("    {}\n", port.by_id));
  }
  if (ports.empty())
    put_error("no serial port is there: is the machine plugged in and switched on?");
  return ExitCode::Done;
}

ExitCode list_robots(const std::vector<std::string>& asked) {
  for (const std::string& name : asked) {
    const motion::RobotModel robot = load_robot(name);
    put_result(describe(robot) + describe_more(robot));
  }
  if (!asked.empty()) return ExitCode::Done;
  for (const motion::EmbeddedRobot& robot : motion::embedded_robots()) {
    put_result(describe(load_robot(std::string(robot.name))));
  }
  return ExitCode::Done;
}

}  // namespace rob::runtime
