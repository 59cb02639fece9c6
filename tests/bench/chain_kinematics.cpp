/// What a pose of a chain costs: going on along a path, and the search for all solutions, beside
/// KDL's iteration (Levenberg-Marquardt) from within 0.02 rad, and from the robot's start, in the
/// same run. Also how many of the poses are found within the limits.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <memory>
#include <random>
#include <vector>

#include "motion/kinematics/chain_kinematics.h"
#include "motion/robots/robot_library.h"
#include "tests/motion/kinematics/five_axes.h"
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

/// Whether whole turns bring it within the limits.
bool turns_within(const RobotModel& robot, const JointVector& q) {
  for (int i = 0; i < robot.axis_count(); ++i) {
    const Axis& axis = robot.axes[static_cast<std::size_t>(i)];
    const double turns = std::ceil((axis.min - 1e-9 - q[i]) / rob::kFullTurn);
    const double value = axis.kind == AxisKind::Linear ? q[i] : q[i] + rob::kFullTurn * turns;
    if (!(value >= axis.min - 1e-9 && value <= axis.max + 1e-9)) return false;
  }
  return true;
}

void print(const char* name, const RobotModel& robot) {
  const auto& kinematics = dynamic_cast<const ChainKinematics&>(*robot.kinematics);
  KdlChain kdl = KdlChain::of(kinematics.chain());
  const std::vector<Place> all = places(robot);
  JointVector q;
  const Cost on = cost_of(all, [&](const Place& place) {
    return kinematics.inverse(place.pose, place.beside).has_value();
  });
  const Cost search = cost_of(all, [&](const Place& place) {
    const InverseSolutions found = kinematics.solutions(place.pose, robot.start);
    return std::any_of(found.begin(), found.end(),
                       [&](const JointVector& one) { return turns_within(robot, one); });
  });
  const Cost theirs =
      cost_of(all, [&](const Place& place) { return kdl.inverse(place.pose, place.beside, q); });
  const Cost their_search = cost_of(all, [&](const Place& place) {
    return kdl.inverse(place.pose, robot.start, q) && turns_within(robot, q);
  });
  fmt::print("{:<11} {:6.2f} {:6.2f} % {:8.1f} {:6.2f} % {:8.1f} {:6.2f} % {:8.0f} {:6.2f} %\n",
             name, on.time, on.found, search.time, search.found, theirs.time, theirs.found,
             their_search.time, their_search.found);
}

/// Six axes of any lengths and directions, each with a range of 200 … 340°.
RobotModel odd_arm(unsigned number) {
  RobotModel robot = embedded_robot("ur5e");
  std::mt19937 random(number);
  std::uniform_real_distribution<double> length(-0.3, 0.3);
  std::uniform_real_distribution<double> half(100, 170);
  std::normal_distribution<double> any;
  const auto pose = [&] {
    return Pose{
        {length(random), length(random), length(random)},
        Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized()};
  };
  std::vector<ChainJoint> joints;
  for (Axis& axis : robot.axes) {
    axis.max = half(random) * rob::kDegree;
    axis.min = -axis.max;
    joints.push_back({pose(), false, axis.min, axis.max});
  }
  robot.kinematics = std::make_shared<ChainKinematics>(JointChain(std::move(joints), pose()), 6,
                                                       std::vector{0, 1, 2, 3, 4, 5});
  robot.start = JointVector::Zero(6);
  return robot;
}

}  // namespace

int main() {
  fmt::print(
      "us a pose, found going on          search           KDL, going on       KDL, from its "
      "start\n");
  for (const char* const name : {"ur5e", "ur10e", "fr3", "t3", "lwa4p_urdf"})
    print(name, embedded_robot(name));
  print("five axes", rob::test::five_axes());
  for (const unsigned number : {1U, 2U, 3U})
    print(fmt::format("odd {}", number).c_str(), odd_arm(number));
}
