/// What a pose of a chain costs: going on along a path, and the search for all solutions, beside
/// KDL's iteration (Levenberg-Marquardt) from within 0.02 rad, in the same run. Also how many of
/// the poses are found.

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <random>
#include <vector>

#include "motion/plan/reach.h"
#include "motion/robots/robot_library.h"
#include "tests/support/kdl_chain.h"

namespace {

using namespace rob::motion;
using rob::test::KdlChain;

constexpr int kPoses = 10'000;

struct Place {
  JointVector beside;  ///< up to 0.02 rad from the axis values: where an iteration begins
  Pose pose;
};

std::vector<Place> places(const RobotModel& robot) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> step(-0.02, 0.02);
  std::vector<Place> all(kPoses);
  for (Place& place : all) {
    JointVector q(robot.axis_count());
    for (int i = 0; i < q.size(); ++i) {
      const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
      q[i] = std::uniform_real_distribution<double>(axis.min, axis.max)(random);
    }
    place.pose = robot.kinematics->forward(q);
    place.beside = q;
    for (double& value : place.beside) value += step(random);
  }
  return all;
}

struct Cost {
  double time = 0;   ///< us of processor time a call
  double found = 0;  ///< % of the calls
};

/// `call`: whether it has found the pose.
template <typename Call>
Cost cost_of(const std::vector<Place>& all, const Call& call) {
  int found = 0;
  const std::clock_t begin = std::clock();
  for (const Place& place : all) found += call(place) ? 1 : 0;
  const double time = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  const auto count = static_cast<double>(all.size());
  return {time * 1e6 / count, 100 * found / count};
}

void print(const char* name, KdlChain kdl) {
  const RobotModel robot = embedded_robot(name);
  const Kinematics& kinematics = *robot.kinematics;
  const std::vector<Place> all = places(robot);
  JointVector q;
  const Cost on = cost_of(all, [&](const Place& place) {
    return kinematics.inverse(place.pose, place.beside).has_value();
  });
  const Cost search = cost_of(all, [&](const Place& place) {
    return kinematics.solutions(place.pose, robot.start).count > 0;
  });
  const Cost theirs =
      cost_of(all, [&](const Place& place) { return kdl.inverse(place.pose, place.beside, q); });
  fmt::print("{:<8} {:8.2f} {:6.2f} %   {:8.1f} {:6.2f} %   {:8.1f} {:6.2f} %\n", name, on.time,
             on.found, search.time, search.found, theirs.time, theirs.found);
}

}  // namespace

int main() {
  fmt::print("us a pose, found    going on           search           KDL, going on\n");
  print("ur5e", KdlChain::standard(rob::test::ur5e_table()));
  print("ur10e", KdlChain::standard(rob::test::ur10e_table()));
  print("fr3", KdlChain::craig(rob::test::fr3_table()));
}
