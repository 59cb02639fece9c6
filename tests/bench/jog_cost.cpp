// What a period of a jog costs: the step of the velocity mode, of each robot in each space, while
// the rates change at random and lead into ends, singular places and the border of the reach.
#include <ctime>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "motion/generate/velocity_mode.h"
#include "motion/robots/robot_library.h"

namespace {

using rob::motion::JogRates;
using rob::motion::RobotModel;
using rob::motion::VelocityMode;
using Space = JogRates::Space;

constexpr double kSeconds = 20;  // of jogging, for each line
constexpr double kRenewed = 0.5;

/// Up to the speeds of the axes; of the tool up to 0.3 m/s and 1 rad/s, a tenth of it on a table.
JogRates random_rates(const RobotModel& robot, Space space, std::mt19937& random) {
  std::uniform_real_distribution<double> share(-1, 1);
  const bool plane = robot.axis_count() == 3;
  JogRates rates;
  rates.space = space;
  rates.rate.setZero(space == Space::Joint ? robot.axis_count() : 6);
  for (int i = 0; i < rates.rate.size(); ++i) {
    const double speed = i >= 3 ? 1 : plane ? 0.03 : 0.3;
    const double most =
        space == Space::Joint ? robot.axes[static_cast<std::size_t>(i)].v_max : speed;
    if (space == Space::Joint || !plane || i < 2 || i == 5) rates.rate[i] = share(random) * most;
  }
  return rates;
}

/// Processor time, µs: on a busy machine, too, what the step itself takes.
double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e6 + static_cast<double>(time.tv_nsec) / 1e3;
}

/// µs of each step, in order of size.
std::vector<double> costs_of(const RobotModel& robot, Space space) {
  VelocityMode mode(robot);
  std::mt19937 random(1);
  std::vector<double> costs;
  const auto periods = static_cast<int>(kSeconds / robot.reference_period);
  const auto renewed = static_cast<int>(kRenewed / robot.reference_period);
  for (int i = 0; i < periods; ++i) {
    if (i % renewed == 0) mode.aim(random_rates(robot, space, random));
    const double begun = now();
    mode.step(1);
    costs.push_back(now() - begun);
  }
  std::ranges::sort(costs);
  return costs;
}

void print_costs(const RobotModel& robot, const std::string& name) {
  for (const auto& [space, words] :
       {std::pair{Space::Joint, "joint"}, {Space::World, "world"}, {Space::Tool, "tool"}}) {
    const std::vector<double> costs = costs_of(robot, space);
    fmt::print("{:16}{:8}{:10.1f}{:10.1f}{:10.1f}{:10.1f}\n", name, words, costs[costs.size() / 2],
               costs[costs.size() * 99 / 100], costs[costs.size() * 999 / 1000], costs.back());
  }
}

}  // namespace

int main() {
  fmt::print("{:16}{:8}{:>10}{:>10}{:>10}{:>10}  µs\n", "robot", "rates", "median", "99 %",
             "99.9 %", "most");
  for (const char* name : {"gantry", "ums7", "pc104", "puma560", "lwa4p", "irb120"}) {
    print_costs(rob::motion::embedded_robot(name), name);
  }
  for (const char* name : {"puma560", "lwa4p"}) {
    RobotModel robot = rob::motion::embedded_robot(name);
    robot.reference_period = 0.001;
    print_costs(robot, fmt::format("{} at 1 kHz", name));
  }
}
