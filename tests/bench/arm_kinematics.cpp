/// What a pose of an arm costs: forward, all solutions, the nearest one, the Jacobian. Where KDL is
/// installed (liborocos-kdl-dev) also the same of its solvers, in the same run.

#include "motion/kinematics/arm_kinematics.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <random>
#include <vector>

#include "motion/robots/robot_library.h"
#ifdef ROB_BENCH_KDL
#include "tests/bench/kdl_arm.h"
#endif

namespace {

using namespace rob::motion;

constexpr int kPoses = 100'000;
constexpr int kTurns = 5;

struct Place {
  JointVector q;
  JointVector beside;  ///< up to 0.1 rad from q: where an iteration begins
  Pose pose;
};

std::vector<Place> places(const Kinematics& kinematics) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-3, 3);
  std::uniform_real_distribution<double> step(-0.1, 0.1);
  std::vector<Place> all(kPoses);
  for (Place& place : all) {
    place.q.resize(kinematics.axes());
    for (double& value : place.q) value = angle(random);
    place.beside = place.q;
    for (double& value : place.beside) value += step(random);
    place.pose = kinematics.forward(place.q);
  }
  return all;
}

/// µs of processor time a call, the best of `turns`; `call` returns a number so that nothing is
/// left out.
template <typename Call>
double time_of(const std::vector<Place>& all, const Call& call, int turns = kTurns) {
  double least = 1e9;
  double sum = 0;
  for (int turn = 0; turn < turns; ++turn) {
    const std::clock_t begin = std::clock();
    for (const Place& place : all) sum += call(place);
    least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return sum == 0.5 ? 0 : least * 1e6 / static_cast<double>(all.size());
}

struct Times {
  double forward, solutions, inverse, jacobian;
};

Times times_of(const ArmKinematics& arm, const std::vector<Place>& all) {
  return {
      time_of(all, [&](const Place& place) { return arm.forward(place.q).position.x(); }),
      time_of(all, [&](const Place& place) { return arm.solutions(place.pose, place.q).count; }),
      time_of(all, [&](const Place& place) { return (*arm.inverse(place.pose, place.beside))[5]; }),
      time_of(all, [&](const Place& place) { return arm.jacobian(place.q)(2, 2); })};
}

#ifdef ROB_BENCH_KDL
/// KDL's times, and how many times as long that is. False: its arm is another one.
bool print_kdl(const ArmKinematics& arm, const std::vector<Place>& all, const Times& ours) {
  const ArmParameters& p = arm.parameters();
  rob::bench::KdlArm kdl(p);
  std::vector<Place> theirs = all;  // in θ
  double difference = 0;
  for (Place& place : theirs) {
    for (int i = 0; i < 6; ++i) {
      const auto at = static_cast<std::size_t>(i);
      place.q[i] = p.sign[at] * place.q[i] + p.offset[at];
      place.beside[i] = p.sign[at] * place.beside[i] + p.offset[at];
    }
    difference = std::max(difference, (kdl.forward(place.q).position - place.pose.position).norm());
  }
  if (difference > 1e-12) return false;
  int failed = 0;
  JointVector found;
  const double forward =
      time_of(theirs, [&](const Place& place) { return kdl.forward(place.q).position.x(); });
  const std::vector<Place> few(theirs.begin(), theirs.begin() + kPoses / 10);
  const double inverse = time_of(
      few,
      [&](const Place& place) {
        if (!kdl.inverse(place.pose, place.beside, found)) return ++failed;
        return 0;
      },
      1);
  const double jacobian =
      time_of(theirs, [&](const Place& place) { return kdl.jacobian(place.q)(2, 2); });
  fmt::print("  KDL      {:9.3f} {:>10} {:8.3f} {:9.3f}   not found: {:.2f} %\n", forward, "-",
             inverse, jacobian, 100.0 * failed / static_cast<double>(few.size()));
  fmt::print("  ratio    {:9.1f} {:>10} {:8.1f} {:9.1f}\n", forward / ours.forward, "-",
             inverse / ours.inverse, jacobian / ours.jacobian);
  return true;
}
#endif

}  // namespace

int main() {
  fmt::print("us a pose    forward  solutions  inverse  jacobian\n");
  for (const char* name : {"ums7", "pc104", "lwa4p", "puma560", "irb120"}) {
    const RobotModel robot = embedded_robot(name);
    const auto& arm = dynamic_cast<const ArmKinematics&>(*robot.kinematics);
    const auto all = places(arm);
    const Times ours = times_of(arm, all);
    fmt::print("{:<10} {:9.3f} {:10.3f} {:8.3f} {:9.3f}\n", name, ours.forward, ours.solutions,
               ours.inverse, ours.jacobian);
#ifdef ROB_BENCH_KDL
    if (!print_kdl(arm, all, ours)) {
      fmt::print(stderr, "arm_kinematics: KDL's {} is another arm\n", name);
      return 1;
    }
#endif
  }
}
