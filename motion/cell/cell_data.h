#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace rob::motion {

// The surroundings of the tool of a simulated robot (docs/adding-a-robot.md), SI, in the world's
// frame, z up. Plain data, from the robot file.

/// How a simulated force sensor errs.
struct SensorErrors {
  double period = 1e-3;     ///< s from sample to sample
  double force_noise = 0;   ///< N, standard deviation of each component
  double torque_noise = 0;  ///< Nm
  Eigen::Vector3d force_bias = Eigen::Vector3d::Zero();   ///< N, added to what acts
  Eigen::Vector3d torque_bias = Eigen::Vector3d::Zero();  ///< Nm
  double delay = 0;                                       ///< s from what acts to what is reported
};

/// How hard, rough and quick everything is that the tool touches.
struct ContactData {
  double stiffness = 50e3;        ///< N/m as seen at the tool, the arm's own included
  double damping_time = 1e-3;     ///< s: damping over stiffness
  double friction = 0.2;          ///< Coulomb's, 1
  double torsion = 100;           ///< Nm/rad of hand and wrist about the vertical
  double fall_speed = 3e-3;       ///< m/s with which a tube sinks into a hole by itself
  double fall_resistance = 2000;  ///< N·s/m: what a tube takes to sink faster
};

/// A gripper with parallel jaws that points along the flange's z.
struct GripperData {
  int closed_input = 0;  ///< channel that shows that the jaws have closed, on something or not
  int held_input = 0;    ///< channel that shows that something is between them
  double tip = 0;        ///< m from the flange to the point between the jaws where it grips
  double fingers = 0;    ///< m from there to the ends of the fingers
  double palm = 0;       ///< m from there back to the palm, which meets what is too high
  double reach = 0;      ///< m beside the tip at which it still takes hold
};

struct TubeData {
  double length = 0;  ///< m
  double radius = 0;  ///< m
};

/// Seated after `turns` of its thread; the friction torque rises over the last `rise` of them.
struct CapData {
  double height = 0;          ///< m
  double overlap = 0;         ///< m that a loose cap reaches down over the tube
  double pitch = 0;           ///< m a turn
  double turns = 0;           ///< rad from where it begins to bite to its seat
  double running_torque = 0;  ///< Nm
  double rise = 0;            ///< rad
  double slip_torque = 0;     ///< Nm at its seat, and where the jaws slip on it
};

/// Holes of one kind in rows and columns, columns along x, rows along y.
struct RackData {
  enum class Fill : std::uint8_t { Empty, Tubes, CappedTubes };  ///< the caps stand loose

  double x = 0;  ///< m, the first hole
  double y = 0;
  double face = 0;  ///< m, height of its upper side
  double depth = 0;
  double pitch = 0;      ///< m from hole to hole
  double clearance = 0;  ///< m, radius of the hole less that of the tube
  double chamfer = 0;    ///< m, at 45°, of the edge
  int columns = 1;
  int rows = 1;
  Fill fill = Fill::Empty;
  Eigen::Vector2d error = Eigen::Vector2d::Zero();  ///< m by which the holes are beside their place
};

/// A place where there is always another cap.
struct CapSupplyData {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< m, middle of the cap's lower side
};

/// From `low` to `high`, both included.
struct Between {
  double low = 0;
  double high = 0;
};

/// Within what cells of one kind differ; SI.
struct CellSpread {
  Between stiffness;
  Between damping_time;
  Between friction;
  Between force_noise;
  Between torque_noise;
  Between force_bias;  ///< of each component
  Between torque_bias;
  Between delay;
  Between running_torque;
  Between slip_torque;
  double hole_error = 0;  ///< m: of the racks that have an error, the greatest
};

struct CellData {
  double table = 0;  ///< m, height of the table
  SensorErrors sensor;
  ContactData contact;
  GripperData gripper;
  TubeData tube;
  CapData cap;
  std::vector<RackData> racks;
  std::vector<CapSupplyData> cap_supplies;
  std::optional<CellSpread> spread;
  std::uint64_t seed = 0;  ///< of noise
};

}  // namespace rob::motion
