#pragma once

#include <cstdint>
#include <string>

namespace rob::drivers {

/// The state that a servo on a bus reports each cycle.
struct ServoReading {
  double position = 0;  ///< ticks, 4096 a turn
  double velocity = 0;  ///< ticks/s
};

/// A goal for one servo: ticks, and ticks/s at most.
struct ServoGoal {
  std::uint8_t id = 0;
  int position = 0;
  int most_speed = 0;
};

/// The trouble that a servo reports.
struct ServoHealth {
  bool torque = false;
  std::string trouble;  ///< empty: nothing
};

/// Questions for readings that can be distinguished. No protocol here numbers its packets, so each
/// turn asks for another number of bytes: the size of an answer shows which question it belongs to.
inline constexpr int kTurns = 8;

/// A register and the value it must hold.
struct ServoSetting {
  int address = 0;
  int size = 1;
  std::uint32_t value = 0;
};

}  // namespace rob::drivers
