#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "motion/space/pose.h"

/// A robot as a URDF describes it: links, and joints between them. m, rad.
namespace rob::runtime {

/// A body that a link is made of, for collisions.
struct UrdfShape {
  enum class Kind { Box, Cylinder, Sphere, Mesh };

  Kind kind = Kind::Box;
  motion::Pose place;                              ///< of its middle, in the frame of its link
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  ///< of a box
  double radius = 0;                               ///< of a cylinder or sphere
  double length = 0;                               ///< of a cylinder, along its z
  std::string mesh;  ///< as written: package://…, file://… or a path
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();  ///< of a mesh
};

struct UrdfLink {
  std::string name;
  std::vector<UrdfShape> shapes;
};

struct UrdfJoint {
  enum class Kind { Fixed, Revolute, Continuous, Prismatic, Other };

  std::string name;
  Kind kind = Kind::Fixed;
  std::string parent;  ///< a link
  std::string child;
  motion::Pose place;  ///< the child's frame in that of the parent, at zero
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();  ///< in the child's frame, as written
  bool limited = false;                             ///< it has a <limit>: the four below
  double lower = 0;
  double upper = 0;
  double velocity = 0;
  double effort = 0;   ///< N or Nm
  std::string mimics;  ///< the joint that it follows; empty: none
};

struct Urdf {
  std::string name;
  std::string root;  ///< the only link without a parent
  std::vector<UrdfLink> links;
  std::vector<UrdfJoint> joints;

  /// Null: there is none of that name.
  const UrdfJoint* joint(const std::string& called) const;
  /// The joint that carries the link; null: it is the root.
  const UrdfJoint* parent_of(const std::string& link) const;
};

/// Reads a URDF; its joints are a tree. `file` is for messages. Throws motion::RobotFileError for
/// what is no XML, no URDF, a xacro, or not strictly a tree.
Urdf read_urdf(const std::string& text, const std::string& file);

}  // namespace rob::runtime
