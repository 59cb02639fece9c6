#include "runtime/command/motion_requests.h"

namespace rob::runtime {

namespace {

motion::ProfileShape profile_of(lang::Profile profile) {
  switch (profile) {
    case lang::Profile::Rectangular:
      return motion::ProfileShape::Rectangular;
    case lang::Profile::Trapezoidal:
      return motion::ProfileShape::Trapezoidal;
    case lang::Profile::Parabolic:
      return motion::ProfileShape::Parabolic;
    case lang::Profile::Cosine:
      return motion::ProfileShape::Cosine;
    case lang::Profile::Unspecified:
      break;
  }
  return motion::ProfileShape::None;
}

motion::MotionRequest::Bound bound_of(lang::MoveCommand::Bound bound) {
  using From = lang::MoveCommand::Bound;
  using To = motion::MotionRequest::Bound;
  return bound == From::Tool     ? To::Tool
         : bound == From::Rotary ? To::Rotary
         : bound == From::Share  ? To::Share
                                 : To::None;
}

}  // namespace

motion::MotionRequest::Pace pace_of(lang::MoveCommand::Pace pace) {
  using From = lang::MoveCommand::Pace;
  using To = motion::MotionRequest::Pace;
  return pace == From::ToolSpeed      ? To::ToolSpeed
         : pace == From::AngularSpeed ? To::AngularSpeed
         : pace == From::Share        ? To::Share
                                      : To::Unspecified;
}

motion::MotionRequest request_of(int line, const lang::MoveCommand& command) {
  motion::MotionRequest request;
  request.tag = static_cast<motion::Tag>(line);
  request.relative = command.relative;
  request.given = command.given;
  request.target = command.target;
  request.pace = pace_of(command.pace);
  request.pace_value = command.pace_value;
  request.at_least = command.over;
  request.profile = profile_of(command.profile);
  request.accel = bound_of(command.accel);
  request.accel_value = command.accel_value;
  request.jerk = bound_of(command.jerk);
  request.jerk_value = command.jerk_value;
  if (command.exact()) return request;  // at rest there is no corner to be bounded
  using Zone = motion::MotionRequest::Zone;
  request.zone = command.zone == lang::MoveCommand::Zone::Length  ? Zone::Length
                 : command.zone == lang::MoveCommand::Zone::Time  ? Zone::Time
                 : command.zone == lang::MoveCommand::Zone::Share ? Zone::Share
                                                                  : Zone::Robots;
  request.zone_value = command.zone_value;
  request.zone_angle = command.zone_angle;
  return request;
}

}  // namespace rob::runtime
