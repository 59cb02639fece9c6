#include "runtime/command/motion_requests.h"

namespace rob::runtime {

motion::MotionRequest request_of(int line, const lang::MoveCommand& command) {
  motion::MotionRequest request;
  request.tag = static_cast<motion::Tag>(line);
  request.relative = command.relative;
  request.given = command.given;
  request.target = command.target;
  request.pace = command.pace;
  request.pace_value = command.pace_value;
  request.at_least = command.over;
  request.profile = command.profile;
  request.accel = command.accel;
  request.accel_value = command.accel_value;
  request.jerk = command.jerk;
  request.jerk_value = command.jerk_value;
  if (command.exact()) return request;  // at rest there is no corner to be bounded
  request.zone = command.zone;
  request.zone_value = command.zone_value;
  request.zone_angle = command.zone_angle;
  return request;
}

}  // namespace rob::runtime
