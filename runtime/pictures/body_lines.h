#pragma once

#include <vector>

#include "motion/collision/collision_data.h"
#include "motion/robots/robot_model.h"

/// A robot and what stands around it as thick lines, for pictures.
namespace rob::runtime {

/// All that is within `radius` of a segment, m, in the world.
struct BodyLine {
  Eigen::Vector3d from = Eigen::Vector3d::Zero();
  Eigen::Vector3d to = Eigen::Vector3d::Zero();
  double radius = 0;  ///< 0: a line
};

/// The capsules of the robot's file at these axis values; without any, lines from axis to axis.
/// Always as many.
std::vector<BodyLine> lines_of_robot(const motion::RobotModel& robot, const motion::JointVector& q);

/// The edges of a box or a mesh, three circles of a sphere, the line of a capsule, a square of a
/// table.
std::vector<BodyLine> lines_of_obstacle(const motion::Obstacle& obstacle);

}  // namespace rob::runtime
