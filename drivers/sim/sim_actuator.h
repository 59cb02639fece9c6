#pragma once

#include <cstdint>

namespace rob::drivers {

/// Channels 0…63, as bits of ServoCommand::outputs and ServoState::inputs.
struct SimActuatorParameters {
  int output = 0;          ///< drives it to its ON end while set, to its OFF end while not
  int input_off = 0;       ///< set while it stands at its OFF end
  int input_on = 0;        ///< set while it stands at its ON end
  double travel_time = 0;  ///< s from end to end
};

/// A two-position actuator: a lift, a gripper. It travels at constant speed, and may be turned
/// round on the way. Every call but the constructor may be used in the tick.
class SimActuator {
 public:
  explicit SimActuator(const SimActuatorParameters& parameters) : parameters_(parameters) {}

  /// At its OFF end, commanded to stay there.
  void place_off() noexcept;
  void command(double now, std::uint64_t outputs) noexcept;
  /// Its two bits.
  std::uint64_t inputs(double now) const noexcept;
  /// 0: OFF end, 1: ON end.
  double position(double now) const noexcept;

 private:
  SimActuatorParameters parameters_;
  bool on_ = false;  // where it is going
  double from_ = 0;  // where it was at since_
  double since_ = 0;
};

}  // namespace rob::drivers
