#include "runtime/control/motion_chain.h"

#include "motion/generate/paul_generator.h"

namespace rob::runtime {

MotionChain::MotionChain(const motion::RobotModel& robot)
    : buffer(static_cast<std::size_t>(robot.look_ahead)),
      planner(robot, robot.start),
      generator(std::make_unique<motion::PaulGenerator>(robot, buffer, robot.start)) {}

}  // namespace rob::runtime
