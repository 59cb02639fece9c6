#pragma once

#include <cstdint>

#include "lang/machine/move_command.h"
#include "motion/plan/segment_descriptor.h"
#include "runtime/command/surroundings.h"

namespace rob::runtime {

/// A PRESS on the program's side: how far it is, and what of motions lies along its axis, on which
/// the force leads the tool and nothing else may.
class PressLine {
 public:
  enum class State : std::uint8_t { No, Seeking, Yes, Ending, EndingLost, EndingAtEnd };

  PressLine(const RobotLinks& links, const Surroundings& surroundings)
      : links_(links), surroundings_(surroundings) {}

  State state() const { return state_; }
  bool present() const { return state_ != State::No; }
  /// Asks motion for it; the axes stand.
  void seek(const motion::PressOrder& order);
  /// The force has been reached.
  void keep() { state_ = State::Yes; }
  /// Asks motion to end it.
  void ask_to_end();
  /// It is over; how it was when it ended.
  State leave();

  /// A target as the program means it.
  motion::Pose across(motion::Pose target, const lang::MoveCommand& command) const;
  /// A target that lies elsewhere along the axis than the tool stands now on its path.
  bool forbids(const motion::Pose& target) const;
  /// A jog that would move the tool along it.
  bool forbids(const motion::JogRates& rates) const;

 private:
  const Eigen::Vector3d& axis() const { return links_.channels.press.order.axis; }

  const RobotLinks& links_;
  const Surroundings& surroundings_;
  State state_ = State::No;
};

}  // namespace rob::runtime
