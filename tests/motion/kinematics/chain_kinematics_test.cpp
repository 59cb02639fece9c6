#include "motion/kinematics/chain_kinematics.h"

#include <doctest/doctest.h>

#include <memory>
#include <random>
#include <vector>

#include "motion/robots/robot_file.h"
#include "motion/robots/robot_library.h"
#include "tests/support/degrees.h"
#include "tests/support/kdl_chain.h"

namespace rob::motion {
using test::kDegree;

namespace {

JointVector joints(double pan, double lift, double elbow, double wrist, double roll, double grip) {
  JointVector q(6);
  q << pan, lift, elbow, wrist, roll, grip;
  return q * kDegree;
}

void check_near(const Eigen::Vector3d& found, double x, double y, double z) {
  CHECK((found * 1000 - Eigen::Vector3d(x, y, z)).norm() < 1e-6);
}

}  // namespace

// By hand: at zero the frames of the SO-101 are turned by whole quarters, so that its places add
// up. x: 30.399 + 28 + 134.9 + 61.1 + 98.127; y: −18.278 + 18.1 − 0.218; z: 94.882 + 54.2 + 112.57
// + 5.2 − 7.9.
TEST_CASE("the SO-101 at zero points ahead, its tips where the published places add up to") {
  const RobotModel robot = embedded_robot("so101");
  const Pose tool = robot.kinematics->forward(joints(0, 0, 0, 0, 0, 0));
  check_near(tool.position, 352.526, -0.396, 258.952);
  CHECK((tool.orientation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitX()).norm() < 1e-9);
}

TEST_CASE("its pan turns about the upright axis, downwards; the gripper moves nothing") {
  const RobotModel robot = embedded_robot("so101");
  check_near(robot.kinematics->forward(joints(90, 0, 0, 0, 0, 0)).position, -0.396, -352.526,
             258.952);
  check_near(robot.kinematics->forward(joints(0, 0, 0, 0, 0, 80)).position, 352.526, -0.396,
             258.952);
  CHECK(robot.kinematics->lever(5, {0, 0, 0.1}) == 0);
}

// About axis 2 at (30.399, ·, 149.082) a quarter forwards: (x, z) → (30.399 + (z − 149.082),
// 149.082 − (x − 30.399)).
TEST_CASE("its lift leans it forward") {
  const RobotModel robot = embedded_robot("so101");
  check_near(robot.kinematics->forward(joints(0, 90, 0, 0, 0, 0)).position,
             30.399 + (258.952 - 149.082), -0.396, 149.082 - (352.526 - 30.399));
}

// The numbers of so101_new_calib.urdf under KDL, which shares no code with Rob. Its base is 38.8353
// mm behind axis 1, and its roll has another zero: 0.0486795 rad, in the rpy of that joint.
TEST_CASE("its tips are where KDL brings those of the published model") {
  struct Joint {
    double x, y, z, roll, pitch, yaw;
  };
  constexpr double kHalf = 3.14159265358979324;
  const Joint joints_of_model[] = {{0, 0, 0.094882, kHalf, 0, -kHalf},
                                   {-0.0303992, -0.0182778, -0.0542, -kHalf / 2, -kHalf / 2, 0},
                                   {-0.11257, -0.028, 0, 0, 0, kHalf / 2},
                                   {-0.1349, 0.0052, 0, 0, 0, -kHalf / 2},
                                   {0, -0.0611, 0.0181, kHalf / 2, 0.0486795, kHalf}};
  KDL::Chain chain;
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None)));
  const auto place = [](const Joint& at) {
    return KDL::Frame(KDL::Rotation::RPY(at.roll, at.pitch, at.yaw), KDL::Vector(at.x, at.y, at.z));
  };
  for (const Joint& joint : joints_of_model) {
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), place(joint)));
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::RotZ)));
  }
  const Joint tips{-0.0079, -0.000218121, -0.0981274, 0, kHalf, 0};
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), place(tips)));
  const RobotModel robot = embedded_robot("so101");
  KDL::ChainFkSolverPos_recursive solver(chain);
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i) {
    JointVector q(6);
    KDL::JntArray same(5);
    for (int axis = 0; axis < 6; ++axis) {
      const Axis& limits = robot.axes[static_cast<std::size_t>(axis)];
      q[axis] = std::uniform_real_distribution<double>(limits.min, limits.max)(random);
      if (axis < 5) same(static_cast<unsigned>(axis)) = q[axis];
    }
    same(4) += 0.0486795;
    KDL::Frame there;
    REQUIRE(solver.JntToCart(same, there) >= 0);
    const Pose tool = robot.kinematics->forward(q);
    CHECK((tool.position - Eigen::Vector3d(there.p.x(), there.p.y(), there.p.z())).norm() < 2e-6);
    const KDL::Vector z = there.M.UnitZ();
    CHECK((tool.orientation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d(z.x(), z.y(), z.z()))
              .norm() < 1e-6);
  }
}

TEST_CASE("no axis moves the tips further than its lever says") {
  const RobotModel robot = embedded_robot("so101");
  const JointVector q = joints(10, 20, -30, 40, 50, 0);
  const Eigen::Vector3d from = robot.kinematics->forward(q).position;
  for (int i = 0; i < 5; ++i) {
    JointVector moved = q;
    moved[i] += 1e-4;
    const double way = (robot.kinematics->forward(moved).position - from).norm();
    CHECK(way <= 1e-4 * robot.kinematics->lever(i, Eigen::Vector3d::Zero()));
  }
}

TEST_CASE("a chain of less than six axes that leaves nothing free knows no way back") {
  const RobotModel arm = embedded_robot("so101");
  const JointChain& chain = dynamic_cast<const ChainKinematics&>(*arm.kinematics).chain();
  RobotModel robot = arm;
  robot.kinematics = std::make_shared<ChainKinematics>(chain, 6, std::vector<int>{}, Freedom::None);
  CHECK_FALSE(robot.kinematics->inverts());
  CHECK(robot.kinematics->solutions(Pose{}, robot.start).count == 0);
}

}  // namespace rob::motion
