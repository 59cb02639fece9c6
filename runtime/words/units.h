#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "motion/robots/robot_model.h"

/// The border between what people read (mm, deg) and what motion computes with (m, rad).
namespace rob::runtime {

inline constexpr double kDegreesPerRadian = 57.295779513082320877;  // 180 / π
inline constexpr double kMillimetresPerMetre = 1000.0;

/// Factor from SI to the unit in which an axis of this kind is shown: mm or deg, or their rates.
constexpr double shown_per_si(motion::AxisKind kind) {
  return kind == motion::AxisKind::Linear ? kMillimetresPerMetre : kDegreesPerRadian;
}

/// "mm" or "deg".
constexpr const char* unit_name(motion::AxisKind kind) {
  return kind == motion::AxisKind::Linear ? "mm" : "deg";
}

/// The axis of this number, from 0 on.
inline const motion::Axis& axis_of(const motion::RobotModel& robot, int number) {
  return robot.axes.at(static_cast<std::size_t>(number));
}

/// "400 mm", "12.5 deg": at most six decimals, no trailing zeros.
std::string shown(double si, motion::AxisKind kind);

/// A plain number with at most `decimals` decimals and no trailing zeros; never "-0".
std::string shown(double value, int decimals);

/// With all of its decimals, for columns; never "-0.00".
std::string fixed(double value, int decimals);

/// "x 40 mm, y 12.5 mm, theta 0 deg".
std::string axes_text(const motion::RobotModel& robot, const motion::JointVector& q);

/// Whether an axis stands beside its reference by more than the eye, or its encoder, can tell.
bool stands_beside(const motion::Axis& axis, double measured, double reference);

/// Where the axes stand: as axes_text(), measured to 0.01 mm or deg, and of an axis that
/// stands_beside() its reference, that too: "pan -3.05 deg (its reference is -21.3 deg)".
std::string stand_text(const motion::RobotModel& robot, const motion::JointVector& measured,
                       const motion::JointVector& reference);

/// Each axis in mm or deg.
std::vector<double> shown_joints(const motion::RobotModel& robot, const motion::JointVector& q);

/// ",q1,q2,q3,dq1,dq2,dq3": the names of columns, each of them for every axis.
std::string axis_columns(const motion::RobotModel& robot, std::initializer_list<const char*> names);

/// x, y, z in mm, a, b, c in deg.
std::vector<double> shown_pose(const motion::Pose& pose);

}  // namespace rob::runtime
