/// What a pose of an arm costs: forward, all solutions, the nearest one, the Jacobian.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <random>
#include <vector>

#include "motion/kinematics/arm_kinematics.h"
#include "motion/robots/robot_library.h"

namespace {

using namespace rob::motion;

constexpr int kPoses = 100'000;
constexpr int kTurns = 5;

struct Place {
  JointVector q;
  Pose pose;
};

std::vector<Place> places(const Kinematics& kinematics) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-3, 3);
  std::vector<Place> all(kPoses);
  for (Place& place : all) {
    place.q.resize(kinematics.axes());
    for (double& value : place.q) value = angle(random);
    place.pose = kinematics.forward(place.q);
  }
  return all;
}

/// µs a call, the best of kTurns; `call` returns a number so that nothing is left out.
template <typename Call>
double time_of(const std::vector<Place>& all, const Call& call) {
  double least = 1e9;
  double sum = 0;
  for (int turn = 0; turn < kTurns; ++turn) {
    const auto begin = std::chrono::steady_clock::now();
    for (const Place& place : all) sum += call(place);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    least = std::min(least, time.count());
  }
  return sum == 0.5 ? 0 : least * 1e6 / kPoses;
}

}  // namespace

int main() {
  fmt::print("us a pose    forward  solutions  inverse  jacobian\n");
  for (const char* name : {"ums7", "pc104", "lwa4p", "puma560", "irb120"}) {
    const RobotModel robot = embedded_robot(name);
    const auto& arm = dynamic_cast<const ArmKinematics&>(*robot.kinematics);
    const auto all = places(arm);
    const double forward =
        time_of(all, [&](const Place& place) { return arm.forward(place.q).position.x(); });
    const double solutions =
        time_of(all, [&](const Place& place) { return arm.solutions(place.pose, place.q).count; });
    const double inverse =
        time_of(all, [&](const Place& place) { return (*arm.inverse(place.pose, place.q))[5]; });
    const double jacobian =
        time_of(all, [&](const Place& place) { return arm.jacobian(place.q)(2, 2); });
    fmt::print("{:<10} {:9.3f} {:10.3f} {:8.3f} {:9.3f}\n", name, forward, solutions, inverse,
               jacobian);
  }
}
