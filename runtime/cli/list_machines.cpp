#include "runtime/cli/list_machines.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "drivers/serial/port_list.h"
#include "motion/plan/capability.h"
#include "motion/robots/robot_library.h"
#include "runtime/run/console.h"
#include "runtime/run/load.h"
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

ExitCode list_robots() {
  for (const motion::EmbeddedRobot& robot : motion::embedded_robots()) {
    put_result(describe(load_robot(std::string(robot.name))));
  }
  return ExitCode::Done;
}

}  // namespace rob::runtime
