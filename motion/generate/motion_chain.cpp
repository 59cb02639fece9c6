#include "motion/generate/motion_chain.h"

#include <algorithm>

#include "motion/generate/look_ahead_generator.h"
#include "motion/generate/paul_generator.h"

namespace rob::motion {

namespace {

// [choice] 40 mm of a path in pieces of 5 µm
constexpr std::size_t kPieces = 8192;

/// The number of legs that the ring may hold, so that with the buffer no more is under way than
/// RobotModel says (most_ahead): three are in the planner's hands, and one runs.
std::size_t legs_ahead(const MotionChain::Room& room) {
  return std::max<std::size_t>(room.motions, 4) - 2;
}

/// The other half is in the planner's hands. Handlers that never move need none.
std::size_t short_ahead(const RobotModel& robot, const MotionChain::Room& room) {
  constexpr int kMost = 4096;  // [choice] 2.6 MB: what 20 mm of chords of 5 µm need
  return room.motions > 1 ? static_cast<std::size_t>(std::min(short_ahead(robot) / 2, kMost)) : 0;
}

}  // namespace

MotionChain::Path::Path(const RobotModel& robot, LookAheadBuffer& buffer, const Room& room)
    : ring(room.pieces, std::max(legs_ahead(room), short_ahead(robot, room))),
      planner(robot, buffer, ring, legs_ahead(room)) {}

MotionChain::MotionChain(const RobotModel& robot)
    : MotionChain(robot, {static_cast<std::size_t>(robot.look_ahead), kPieces}) {}

MotionChain::MotionChain(const RobotModel& robot, const Room& room)
    : buffer(room.motions), planner(robot, robot.start) {
  if (robot.law == Law::Paul) {
    generator = std::make_unique<PaulGenerator>(robot, buffer, robot.start);
    return;
  }
  path.emplace(robot, buffer, room);
  generator = std::make_unique<LookAheadGenerator>(robot, buffer, path->ring, robot.start);
}

}  // namespace rob::motion
