#include "lang/machine/move_command.h"

namespace rob::lang {

void take_defaults(const MoveCommand& defaults, MoveCommand& command) {
  if (command.kind == MotionKind::Jog) return;
  if (command.pace == MoveCommand::Pace::Unspecified && !command.live) {
    command.pace = defaults.pace;
    command.pace_value = defaults.pace_value;
    command.pace_line = defaults.pace_line;
  }
  if (command.accel == MoveCommand::Bound::Unspecified) {
    command.accel = defaults.accel;
    command.accel_value = defaults.accel_value;
    command.accel_line = defaults.accel_line;
  }
  const bool says_where_it_ends = command.zone != MoveCommand::Zone::Unspecified || command.fine ||
                                  command.profile != Profile::Unspecified;
  if (says_where_it_ends) return;
  command.zone = defaults.zone;
  command.zone_value = defaults.zone_value;
  command.zone_angle = defaults.zone_angle;
  command.fine = defaults.fine;
  command.fine_within = defaults.fine_within;
  command.zone_line = defaults.zone_line;
}

}  // namespace rob::lang
