#pragma once

#include <string>
#include <vector>

#include "motion/space/pose.h"
#include "runtime/import/urdf.h"

/// The arm within a URDF: its axes from base to tip, and the bodies that they move. m, rad.
namespace rob::runtime {

/// Which part of a URDF is the arm.
struct ArmChoice {
  std::string base;     ///< a link; empty: the root
  std::string tip;      ///< a link; empty: the only one without children
  std::string gripper;  ///< a joint off the chain that becomes an axis; empty: none
};

/// Links that move as one: the base, what an axis carries up to the next, or what hangs on the
/// flange.
struct RigidBody {
  std::string link;               ///< as in the URDF
  std::vector<UrdfShape> shapes;  ///< placed in the frame of the body
};

struct ImportedAxis {
  std::string name;   ///< as programs write it
  std::string joint;  ///< as in the URDF
  bool linear = false;
  bool endless = false;  ///< its limits are chosen
  double min = 0;
  double max = 0;
  double v_max = 0;
  double effort = 0;  ///< 0: the URDF has none
  motion::Pose
      place;       ///< its frame in that of the axis before; it turns about z, or slides along it
  RigidBody body;  ///< of the axes of the chain
};

/// A link that is fixed to the flange, as a camera or a tool's tip is.
struct ImportedTool {
  std::string name;    ///< as programs write it
  std::string link;    ///< as in the URDF
  motion::Pose place;  ///< in the frame of the tip
};

struct ImportedArm {
  std::string name;  ///< as programs write it
  RigidBody base;
  std::vector<ImportedAxis> axes;  ///< those of the chain, and then the gripper
  std::size_t chain = 0;           ///< how many of them move the tip
  motion::Pose flange;             ///< the tip's frame in that of the chain's last axis
  RigidBody tool;                  ///< what is fixed to the flange; in the frame of the tip
  std::string tip;
  std::vector<ImportedTool> tools;    ///< in the order of the URDF
  std::vector<std::string> left_out;  ///< "finger_joint (mimic)": joints that are no axes

  bool has_gripper() const { return axes.size() > chain; }
  /// Four axes that turn the tool about the upright alone, as those of a SCARA.
  bool keeps_upright() const;
  /// Five axes turn the tool as the place lets them: c is what that makes of it.
  bool leaves_c() const { return chain == 5; }
  const ImportedAxis& last() const { return axes[chain - 1]; }
};

/// Throws motion::RobotFileError where the URDF or the choice does not give an arm; `file` is for
/// messages.
ImportedArm find_arm(const Urdf& urdf, const ArmChoice& choice, const std::string& file);

}  // namespace rob::runtime
