/// draw_robot FOLDER: draws each robot that is built in, as FOLDER/robot_NAME.svg
/// (docs/robots.md).

#include <exception>

#include "motion/kinematics/chain_kinematics.h"
#include "motion/robots/robot_library.h"
#include "tests/support/robot_drawing.h"

int main(int argc, char** argv) {
  using namespace rob;
  if (argc != 2) {
    fmt::print(stderr, "usage: draw_robot FOLDER\n");
    return 64;
  }
  try {
    for (const motion::EmbeddedRobot& entry : motion::embedded_robots()) {
      const motion::RobotModel robot = motion::embedded_robot(std::string(entry.name));
      const auto* const kinematics = robot.kinematics.get();
      if (!kinematics->inverts()) continue;  // no picture of what is commanded in its axes
      const bool chain = dynamic_cast<const motion::ChainKinematics*>(kinematics) != nullptr;
      const std::string drawing = chain                    ? test::chain_drawing(robot)
                                  : robot.tool_coordinates ? test::arm_drawing(robot)
                                                           : test::gantry_drawing(robot);
      const std::string file = fmt::format("{}/robot_{}.svg", argv[1], entry.name);
      if (test::save_svg(file, test::kDrawingWidth, test::kDrawingHeight, drawing)) continue;
      fmt::print(stderr, "draw_robot: cannot write {}\n", file);
      return 74;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "draw_robot: {}\n", error.what());
    return 70;
  }
}
