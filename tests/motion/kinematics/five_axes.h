#pragma once

#include <memory>
#include <vector>

#include "motion/kinematics/chain_kinematics.h"
#include "motion/robots/robot_library.h"

namespace rob::test {

/// The SO-101 without its gripper, with free = "c": targets (x, y, z, a, b).
inline motion::RobotModel five_axes() {
  using namespace motion;
  RobotModel robot = embedded_robot("so101");
  const JointChain& chain = dynamic_cast<const ChainKinematics&>(*robot.kinematics).chain();
  robot.axes.pop_back();
  robot.gripper = -1;
  robot.start = JointVector(robot.start.head(5));
  robot.coordinates = {0, 1, 2, 3, 4};
  robot.tool_coordinates = true;
  std::vector<ChainJoint> joints;
  for (int i = 0; i < chain.size(); ++i) joints.push_back(chain.joint(i));
  robot.kinematics = std::make_shared<ChainKinematics>(JointChain(joints, chain.flange()), 5,
                                                       robot.coordinates, Freedom::C);
  return robot;
}

}  // namespace rob::test
