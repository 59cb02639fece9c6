#pragma once

#include <array>
#include <string>

#include "motion/robots/robot_model.h"
#include "tests/support/svg.h"

/// The drawings of docs/robots.md: a robot as its file has it, in its start position.
namespace rob::test {

inline constexpr double kDrawingWidth = 880;
inline constexpr double kDrawingHeight = 534;
inline constexpr double kListLeft = 610;  ///< of the axes' list, px

inline constexpr const char* kRed = "#dc2626";    // x
inline constexpr const char* kGreen = "#059669";  // y
inline constexpr const char* kBlue = "#2563eb";   // z

/// A robot's drawing, without the picture around it. Throws std::runtime_error where what is drawn
/// is not where forward kinematics has the tool.
std::string arm_drawing(const motion::RobotModel& robot);
std::string chain_drawing(const motion::RobotModel& robot);
std::string gantry_drawing(const motion::RobotModel& robot);

/// Title, and at the right each axis with limits and start.
std::string drawing_frame(const motion::RobotModel& robot, const std::string& view);

// Strokes with a meaning.
std::string arrow(Point from, Point to, const char* colour);
/// A line of dimension between two points, `away` px to the left of the way from one to the other,
/// with its length in words.
std::string dimension(Point from, Point to, double away, const std::string& words);
/// Three axes at a point, each as its direction to the right, up and into the page.
using Direction = std::array<double, 3>;
std::string coordinate_frame(Point at, const std::array<Direction, 3>& axes);

}  // namespace rob::test
