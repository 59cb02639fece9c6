#include "runtime/words/units.h"

#include <fmt/format.h>

#include <cmath>

namespace rob::runtime {

std::string shown(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string fixed(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool zero = text.find_first_not_of("-0.") == std::string::npos;
  return zero && text.front() == '-' ? text.substr(1) : text;
}

std::string shown(double si, motion::AxisKind kind) {
  constexpr int kDecimals = 6;  // nm or µdeg: finer than any machine, coarse enough for rounding
  return shown(si * shown_per_si(kind), kDecimals) + " " + unit_name(kind);
}

std::string axes_text(const motion::RobotModel& robot, const motion::JointVector& q) {
  std::string text;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const motion::Axis& axis = axis_of(robot, i);
    text += fmt::format("{}{} {}", i == 0 ? "" : ", ", axis.name, shown(q[i], axis.kind));
  }
  return text;
}

bool stands_beside(const motion::Axis& axis, double measured, double reference) {
  constexpr double kSeen = 0.05;  // mm or deg [choice]
  const double beside = std::abs(measured - reference);
  return beside > axis.drive.encoder_resolution && beside * shown_per_si(axis.kind) > kSeen;
}

std::string stand_text(const motion::RobotModel& robot, const motion::JointVector& measured,
                       const motion::JointVector& reference) {
  constexpr int kDecimals = 2;
  std::string text;
  for (int i = 0; i < robot.axis_count(); ++i) {
    const motion::Axis& axis = axis_of(robot, i);
    const char* const comma = i == 0 ? "" : ", ";
    if (!stands_beside(axis, measured[i], reference[i])) {
      text += fmt::format("{}{} {}", comma, axis.name, shown(reference[i], axis.kind));
      continue;
    }
    text +=
        fmt::format("{}{} {} {} (its reference is {} {})", comma, axis.name,
                    shown(measured[i] * shown_per_si(axis.kind), kDecimals), unit_name(axis.kind),
                    shown(reference[i] * shown_per_si(axis.kind), kDecimals), unit_name(axis.kind));
  }
  return text;
}

std::vector<double> shown_joints(const motion::RobotModel& robot, const motion::JointVector& q) {
  std::vector<double> values;
  for (int i = 0; i < robot.axis_count(); ++i)
    values.push_back(q[i] * shown_per_si(axis_of(robot, i).kind) + 0.0);  // never -0
  return values;
}

std::string axis_columns(const motion::RobotModel& robot,
                         std::initializer_list<const char*> names) {
  std::string columns;
  for (const char* const name : names)
    for (int i = 1; i <= robot.axis_count(); ++i) columns += fmt::format(",{}{}", name, i);
  return columns;
}

std::vector<double> shown_pose(const motion::Pose& pose) {
  const Eigen::Vector3d mm = pose.position * kMillimetresPerMetre;
  const motion::FixedAngles angles = motion::fixed_angles(pose.orientation);
  std::vector<double> values = {mm.x(), mm.y(), mm.z()};
  for (const double angle : {angles.a, angles.b, angles.c})
    values.push_back(angle * kDegreesPerRadian);
  for (double& value : values) value += 0.0;  // makes -0 a 0
  return values;
}

}  // namespace rob::runtime
