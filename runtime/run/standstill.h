#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "runtime/run/controller.h"

namespace rob::runtime {

/// Detects a WAIT for something that never comes, in a run on the virtual clock that nobody drives
/// from outside: the program waits, the axes stand, all that was commanded has acted, and neither
/// an input nor an output has changed for longer than anything in the simulated machine takes. Then
/// nothing is left that could change an input, unless the program reads the time or has something
/// running beside it (lang::Chunk::timed).
class Standstill {
 public:
  explicit Standstill(const motion::RobotModel& robot) {
    for (const motion::TwoPositionActuator& actuator : robot.actuators) {
      longest_ = std::max(longest_, actuator.travel_time);
    }
    longest_ += kMargin;
  }

  /// To be asked once in every cycle.
  bool is_for_ever(Controller& controller, double now) {
    const Channels& channels = controller.channels();
    const std::uint64_t inputs = channels.inputs.load();
    const std::uint64_t outputs = channels.outputs.load();
    const bool same = inputs == inputs_ && outputs == outputs_;
    if (!controller.machine().parts().waits.at_rest()) {
      since_ = kNever;
    } else if (!same || since_ == kNever) {
      since_ = now;
    }
    inputs_ = inputs;
    outputs_ = outputs;
    return now - since_ > longest_;
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  static constexpr double kMargin = 1;  // s. [choice] many cycles of any robot

  double longest_ = 0;  ///< s
  std::uint64_t inputs_ = 0;
  std::uint64_t outputs_ = 0;
  double since_ = kNever;  ///< s: it waits and nothing has changed
};

}  // namespace rob::runtime
