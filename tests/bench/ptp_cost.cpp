// What it costs to find a motion from point to point (docs/performance.md): one axis, and six that
// arrive together, from any state, with limits of speed, acceleration and jerk.
#include <ctime>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "motion/space/point_to_point.h"

namespace {

using rob::motion::JointReference;
using rob::motion::JointVector;
using rob::motion::PointToPoint;

constexpr int kTasks = 500;  // few enough to stay near the processor
constexpr int kRounds = 200;
constexpr double kMotions = kTasks * kRounds;

/// Processor time, µs: on a busy machine, too, what the work itself takes.
double now() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e6 + static_cast<double>(time.tv_nsec) / 1e3;
}

struct Task {
  PointToPoint motion;
  JointReference from;
  JointVector target;
};

/// Limits from 0.1 to 10, states within them, targets up to 3 away.
Task random_task(int axes, std::mt19937& random) {
  std::uniform_real_distribution<double> share(-1, 1);
  const auto vector = [&](auto value) {
    JointVector v(axes);
    for (int i = 0; i < axes; ++i) v[i] = value();
    return v;
  };
  const auto limits = [&] { return vector([&] { return std::pow(10, share(random)); }); };
  const JointVector v_max = limits();
  const JointVector a_max = limits();
  const JointVector j_max = limits() * 10;
  const auto shares = [&] { return vector([&] { return share(random); }); };
  return {PointToPoint(v_max, a_max, j_max),
          {0, shares(), shares().cwiseProduct(v_max), shares().cwiseProduct(a_max)},
          shares() * 3};
}

void measure(int axes) {
  std::mt19937 random(1);
  std::vector<Task> tasks;
  for (int i = 0; i < kTasks; ++i) tasks.push_back(random_task(axes, random));
  std::vector<double> costs;
  double aiming = 0;
  double asking = 0;
  double sum = 0;
  for (int round = 0; round < kRounds; ++round) {
    const double begun = now();
    for (Task& task : tasks) task.motion.aim(task.from, task.target);
    const double aimed = now();
    for (const Task& task : tasks) sum += task.motion.at(task.motion.arrival() / 3).q[0];
    asking += now() - aimed;
    aiming += aimed - begun;
  }
  for (int round = 0; round < kRounds; ++round) {
    for (Task& task : tasks) {
      const double before = now();
      task.motion.aim(task.from, task.target);
      costs.push_back(now() - before);
    }
  }
  std::ranges::sort(costs);
  fmt::print("{:4}{:10.2f}{:10.2f}{:14.3f}   ({:.3g})\n", axes, aiming / kMotions,
             costs[costs.size() * 999 / 1000], asking / kMotions, sum / kMotions);
}

}  // namespace

int main() {
  fmt::print("{:>4}{:>10}{:>10}{:>14}  µs\n", "axes", "aim: mean", "99.9 %", "one reference");
  for (const int axes : {1, 3, 6}) measure(axes);
}
