#include "runtime/command/gripper_elements.h"

namespace rob::runtime {

using lang::MoveCommand;

GripperElements::GripperElements(const MoveCommand& command, const lang::RobotSignature& robot)
    : asked_(command),
      axes_(static_cast<int>(robot.axes.size())),
      shift_(axes_ - static_cast<int>(robot.coordinates.size() + robot.grippers.size())) {
  if (command.means != MoveCommand::Target::Coordinates) return;
  const auto first = static_cast<unsigned>(robot.coordinates.size());
  const unsigned named = command.given >> first;
  given_ = static_cast<std::uint8_t>(named << (axes_ - static_cast<int>(robot.grippers.size())));
  alone_ = named != 0 && command.given == named << first;
}

MoveCommand GripperElements::command() const {
  MoveCommand command = asked_;
  command.means = MoveCommand::Target::Axes;
  command.count = axes_;
  command.given = given_;
  command.target = {};
  for (int i = 0; i < axes_; ++i) {
    if (!command.has(i)) continue;
    command.target[static_cast<std::size_t>(i)] =
        asked_.target[static_cast<std::size_t>(i - shift_)];
  }
  return command;
}

void GripperElements::add_to(MoveCommand& axes, const motion::JointVector& last) const {
  const MoveCommand own = command();
  for (int i = 0; i < axes_; ++i) {
    if (!own.has(i)) continue;
    const auto index = static_cast<std::size_t>(i);
    axes.target[index] = own.target[index] + (own.relative ? last[i] : 0);
  }
}

}  // namespace rob::runtime
