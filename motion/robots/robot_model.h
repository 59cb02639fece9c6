#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/unit_factors.h"
#include "motion/cell/cell_data.h"
#include "motion/collision/collision_data.h"
#include "motion/dynamics/arm_mechanics.h"
#include "motion/kinematics/kinematics.h"
#include "motion/robots/settle_window.h"
#include "motion/servo/drive_data.h"
#include "motion/space/analog_channels.h"
#include "motion/space/joint_vector.h"

namespace rob::motion {

enum class AxisKind : std::uint8_t { Linear, Rotary };
enum class Law : std::uint8_t { Paul, LookAhead };

/// As robot files, the command line and reports call it.
constexpr std::string_view law_name(Law law) noexcept {
  return law == Law::Paul ? "paul" : "lookahead";
}

/// How a machine on a serial line sees an axis (docs/drivers.md); what is left out is chosen by the
/// protocol.
struct WireAxisData {
  int id = -1;        ///< of a servo on a bus; -1: the number of the axis, from 1
  int letter = -1;    ///< of grbl, X = 0; -1: that of the axis' name, or the next that is free
  double travel = 0;  ///< m or rad for a turn of a servo, or for 1 mm of grbl; 0: left out
  double offset = 0;  ///< m or rad where a servo stands in its middle, or grbl at its zero
  int direction = 1;  ///< -1: it counts the other way
};

struct WireData {
  int baud = 0;       ///< 0: the protocol's own
  double period = 0;  ///< s of a cycle; 0: chosen
};

/// One axis: SI (m, m/s, … or rad, rad/s, …).
struct Axis {
  std::string name;
  AxisKind kind = AxisKind::Linear;
  double min = 0;
  double max = 0;
  double v_max = 0;
  double a_max = 0;
  double j_max = 0;  ///< infinite: unlimited
  DriveData drive;
  PulseDriveData pulses;  ///< where RobotModel::servo sends pulses
  WireAxisData wire;
};

/// A digital signal that the robot file declares by name.
struct RobotSignal {
  std::string name;
  bool output = false;
  int channel = 0;
};

/// A two-position actuator of the simulated machine: an output that takes time to act, and the
/// inputs that show when it has arrived. Channels as in RobotSignal.
struct TwoPositionActuator {
  int output = 0;          ///< output channel that drives it
  int input_off = 0;       ///< input channel, true while it stands at its OFF end
  int input_on = 0;        ///< input channel, true while it stands at its ON end
  double travel_time = 0;  ///< s from end to end
};

/// How the simulated arm differs from the one that the servo counts with.
struct SimulatedDeviation {
  double payload = 0;   ///< kg, a point at the flange
  bool fixed = false;   ///< it carries that, whatever the program says; else what that says
  double masses = 1;    ///< factor of the mechanics' table
  double friction = 1;  ///< factor
};

/// The known data of a force sensor, and of what the tool may press on.
struct ForceSensorData {
  double delay = 0;      ///< s from what acts to what is reported
  double limit = 0;      ///< N: a force that ends the run; 0: none
  double noise = 0;      ///< N, by which its report at rest varies; 0: not known
  double stiffness = 0;  ///< N/m: the greatest that the tool meets, the arm's own included
};

/// By how much a corner may miss its point.
struct CornerZone {
  double distance = 1e-3;  ///< m
  double angle = kDegree;  ///< rad, of the orientation and of rotary axes
};

/// Everything that is known of a robot before it moves. Read from a robot file, never changed
/// afterwards, and shared as const.
struct RobotModel {
  std::string name;
  std::string description;
  Law law = Law::Paul;
  double t_acc = 0;     ///< s, half a transition under Paul's law (S1); 0: it has not that law
  CornerZone zone;      ///< of look-ahead's corners where no ZONE is written
  SettleWindow settle;  ///< of FINE, STOP and WAIT; its tip is the flange
  double reference_period = 0;  ///< s
  double servo_period = 0;      ///< s, at most reference_period
  int look_ahead = 0;           ///< segments that the buffer holds
  std::vector<Axis> axes;
  ServoStructure servo = ServoStructure::Force;
  JointVector start;  ///< m, rad: where the simulated robot stands at power-up
  int inputs = 0;     ///< digital channels from 0 on, named or not; at most 64
  int outputs = 0;
  int analog_inputs = 0;  ///< analog channels from 0 on, at most kMostAnalog
  int analog_outputs = 0;
  std::vector<RobotSignal> signals;
  std::vector<TwoPositionActuator> actuators;
  bool force_sensor = false;     ///< it measures forces and torques on the tool
  ForceSensorData force;         ///< only with a force sensor
  std::optional<CellData> cell;  ///< what surrounds the simulated robot's tool
  /// Targets are written as the tool's x, y, z, a, b, c in the world; else as axis values.
  bool tool_coordinates = false;
  /// Which of these, 0 … 5, a target says; only with tool_coordinates.
  std::vector<int> coordinates;
  /// The axis of the gripper, the last one: the tool's place does not tell of it; -1: none.
  int gripper = -1;
  /// Null where this version does not know how the axes move the tool: such a robot cannot be run.
  std::shared_ptr<const Kinematics> kinematics;
  /// The mechanics that the servo feeds forward and the simulation integrates; without it the axes
  /// are decoupled.
  std::optional<ArmMechanics> mechanics;
  SimulatedDeviation deviation;  ///< only with mechanics
  WireData wire;
  CollisionData collision;

  int axis_count() const { return static_cast<int>(axes.size()); }
};

/// Under the look-ahead law so many short motions may be ahead beside look_ahead others: those
/// that are merged into curves, or passed in a few periods. [choice] 40 mm of chords of 5 µm, and
/// more where the program may be farther ahead; 16384 fill the planner's curves of 4096 legs.
inline int short_ahead(const RobotModel& robot) {
  constexpr int kLeast = 8192;
  constexpr int kMost = 16384;
  return robot.law == Law::LookAhead ? std::clamp(8 * robot.look_ahead, kLeast, kMost) : 0;
}

/// How many commanded motions can be unfinished: those in the buffer, and under the look-ahead law
/// as many again whose path is planned, and the short ones.
inline int most_ahead(const RobotModel& robot) {
  return robot.law == Law::LookAhead ? 2 * robot.look_ahead + short_ahead(robot) : robot.look_ahead;
}

}  // namespace rob::motion
