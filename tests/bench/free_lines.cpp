/// Lines with something free: how many of those whose every place is within reach can be run, with
/// it chosen by the ladder and without; and what planning costs a metre.

#include <fmt/format.h>

#include <cmath>
#include <ctime>
#include <random>
#include <string>

#include "motion/path/free_path.h"
#include "motion/path/tool_line.h"
#include "motion/path/way_cost.h"
#include "motion/plan/leg_demand.h"
#include "motion/plan/reach.h"
#include "motion/robots/robot_library.h"

namespace {

using namespace rob::motion;

struct Line {
  JointVector start;
  ToolLine path;
};

JointVector random_within(const RobotModel& robot, std::mt19937& random) {
  JointVector q(robot.axis_count());
  for (int i = 0; i < q.size(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    q[i] = std::uniform_real_distribution<double>(axis.min, axis.max)(random);
  }
  return q;
}

/// Whether some posture within the limits brings the flange to each of some places.
bool within_reach(const RobotModel& robot, const ToolLine& line, const JointVector& start) {
  constexpr int kPlaces = 12;
  for (int k = 1; k <= kPlaces; ++k) {
    const auto q = reach(robot, line.at(static_cast<double>(k) / kPlaces), start);
    if (!q || !axes_within(robot, *q)) return false;
  }
  return true;
}

/// 0.1 … 0.5 m in any direction, with the tool standing.
Line random_line(const RobotModel& robot, std::mt19937& random) {
  std::uniform_real_distribution<double> length(0.1, 0.5);
  std::normal_distribution<double> any;
  for (;;) {
    const JointVector start = random_within(robot, random);
    const Pose from = robot.kinematics->forward(start);
    Pose to = from;
    const Eigen::Vector3d way(any(random), any(random), any(random));
    to.position += way.normalized() * length(random);
    const auto line = ToolLine::between(from, to);
    if (to.position.z() > 0 && line && within_reach(robot, *line, start)) return {start, *line};
  }
}

struct Tally {
  int found = 0;
  double way = 0;   ///< m
  double time = 0;  ///< s of processor time
};

template <typename Follow>
void add(const RobotModel& robot, const Line& line, Tally& tally, const Follow& along) {
  const std::clock_t begin = std::clock();
  const Followed made = along(line);
  tally.time += static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  tally.way += line.path.way();
  if (!made.trouble && !first_beyond(robot, made.axes)) ++tally.found;
}

void measure(const char* name, const FreeTurn& free, int lines) {
  const RobotModel robot = embedded_robot(name);
  std::mt19937 random(1);
  Tally before;
  Tally after;
  for (int i = 0; i < lines; ++i) {
    const Line line = random_line(robot, random);
    add(robot, line, before, [&](const Line& it) { return follow(robot, it.path, {}, it.start); });
    add(robot, line, after, [&](const Line& it) {
      bool chosen = false;
      if (free.kind == Freedom::None) return follow_choosing(robot, it.path, {}, it.start, chosen);
      const TurnedPath turned = choose_turn(robot, it.path, {}, free, it.start);
      return follow_choosing(robot, turned, {}, it.start, chosen);
    });
  }
  const auto share = [&](const Tally& tally) { return 100.0 * tally.found / lines; };
  fmt::print("{:<6} {:<5} {:6.1f} % {:8.1f} ms/m   {:6.1f} % {:8.1f} ms/m\n", name,
             free.kind == Freedom::Spin ? "SPIN"
             : free.kind == Freedom::C  ? "c"
                                        : "-",
             share(before), 1e3 * before.time / before.way, share(after),
             1e3 * after.time / after.way);
}

}  // namespace

int main(int count, char** arguments) {
  const int lines = count > 1 ? std::stoi(arguments[1]) : 300;
  fmt::print("             without             chosen\n");
  measure("fr3", {}, lines);
  measure("ur5e", {Freedom::Spin}, lines);
  measure("ur5e", {Freedom::C}, lines);
  measure("lwa4p", {Freedom::Spin}, lines);
}
