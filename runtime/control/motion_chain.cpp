#include "runtime/control/motion_chain.h"

#include <algorithm>

#include "motion/generate/look_ahead_generator.h"
#include "motion/generate/paul_generator.h"

namespace rob::runtime {

namespace {

/// What the ring may hold, so that with the buffer no more is under way than most_ahead() says:
/// three are in the planner's hands, and one runs.
std::size_t legs_ahead(const motion::RobotModel& robot) {
  return static_cast<std::size_t>(std::max(robot.most_ahead() - robot.look_ahead - 2, 2));
}

}  // namespace

MotionChain::Path::Path(const motion::RobotModel& robot, motion::LookAheadBuffer& buffer,
                        std::size_t pieces)
    : ring(pieces, legs_ahead(robot)), planner(robot, buffer, ring) {}

MotionChain::MotionChain(const motion::RobotModel& robot, std::size_t pieces)
    : buffer(static_cast<std::size_t>(robot.look_ahead)), planner(robot, robot.start) {
  if (robot.law == motion::Law::Paul) {
    generator = std::make_unique<motion::PaulGenerator>(robot, buffer, robot.start);
    return;
  }
  path.emplace(robot, buffer, pieces);
  generator = std::make_unique<motion::LookAheadGenerator>(robot, buffer, path->ring, robot.start);
}

}  // namespace rob::runtime
