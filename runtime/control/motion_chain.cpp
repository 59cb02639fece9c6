#include "runtime/control/motion_chain.h"

#include <algorithm>

#include "motion/generate/look_ahead_generator.h"
#include "motion/generate/paul_generator.h"

namespace rob::runtime {

namespace {

/// What the ring may hold, so that with the buffer no more is under way than RobotModel says
/// (most_ahead): three are in the planner's hands, and one runs.
std::size_t legs_ahead(const MotionChain::Room& room) {
  return std::max<std::size_t>(room.motions, 4) - 2;
}

}  // namespace

MotionChain::Path::Path(const motion::RobotModel& robot, motion::LookAheadBuffer& buffer,
                        const Room& room)
    : ring(room.pieces, legs_ahead(room)), planner(robot, buffer, ring) {}

MotionChain::MotionChain(const motion::RobotModel& robot, const Room& room)
    : buffer(room.motions), planner(robot, robot.start) {
  if (robot.law == motion::Law::Paul) {
    generator = std::make_unique<motion::PaulGenerator>(robot, buffer, robot.start);
    return;
  }
  path.emplace(robot, buffer, room);
  generator = std::make_unique<motion::LookAheadGenerator>(robot, buffer, path->ring, robot.start);
}

}  // namespace rob::runtime
